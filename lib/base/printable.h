// SPDX-License-Identifier: BSD-3-Clause
// Text from files and file names as a terminal may show it: control characters, whole escape sequences among them,
// become '?', and so do bytes that are no UTF-8.
#pragma once
#include <string>
#include <string_view>

namespace base {

// longest: bytes; what is longer is cut and ends in "...".
std::string printable(std::string_view text, size_t longest = std::string_view::npos);

}  // namespace base
