// SPDX-License-Identifier: BSD-3-Clause
// From a graph to the words of the register VM (kernels/cal/cal_vm.h).
#pragma once
#include <string>
#include <vector>
#include "cal/compile.h"
#include "cal/graph.h"

namespace cal {

// Appends the program that writes nodes[i] to output i; returns its entry.  Throws Error(place) if it is too large.
uint32_t generate(const Graph& graph, const std::vector<int>& outputs, const std::string& place, Code& code);

}  // namespace cal
