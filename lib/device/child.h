// SPDX-License-Identifier: BSD-3-Clause
// A question whose answer may cost the life of who asks: OpenCL drivers end the program where they lack /sys or memory.
#pragma once
#include <functional>
#include <optional>
#include <string>

namespace device {

// What `question` returns in a child process; nothing if the child died, threw, or took longer than a minute.  What it
// writes to stderr is lost.
std::optional<std::string> ask_in_child(const std::function<std::string()>& question);

}  // namespace device
