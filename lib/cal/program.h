// SPDX-License-Identifier: BSD-3-Clause
// The way from a graph-making function to a program, with smaller recursion limits until it fits.
#pragma once
#include <functional>
#include "cal/build.h"
#include "cal/compile.h"

namespace cal {

uint32_t with_builder(Library& library, const std::vector<double>& args, const base::Xform& xform,
                      const std::string& place, Code& code,
                      const std::function<std::vector<int>(GraphBuilder&, Graph&)>& make);

}  // namespace cal
