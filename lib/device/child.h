// SPDX-License-Identifier: BSD-3-Clause
// Runs a query in a child process, because OpenCL drivers abort the program if they lack /sys or memory.
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace device {

// Result of `question` in a child process; none if the child died, threw, or took longer than a minute.  Its stderr is
// lost.
std::optional<std::string> ask_in_child(const std::function<std::string()>& question);

}  // namespace device
