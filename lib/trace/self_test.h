// SPDX-License-Identifier: BSD-3-Clause
// Is a device to be believed?  Before its first frame it does some arithmetic (kernels/self_test.h) and renders a small
// room, and both are compared with what the processor gives.
#pragma once
#include <functional>
#include <string>
#include <vector>
#include "trace/device.h"

namespace trace {

// The same bits: "".  Others: a warning, and a name for these bits, which belongs into fingerprints.  Garbage, which is
// more than rounding can explain: throws Error (system).  A result is remembered beside the compiled kernels
// (kernel_cache.h) by `identity`; numbers(n), the first n
// values, is called after the room is rendered.
std::string self_test(const std::string& name, const std::string& identity, Device& device,
                      const std::function<std::vector<float>(uint32_t)>& numbers);

}  // namespace trace
