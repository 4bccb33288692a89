// SPDX-License-Identifier: BSD-3-Clause
// Text from files and file names as a terminal may show it: control characters, whole escape sequences among them,
// become '?', and so do bytes that are no UTF-8.
#pragma once
#include <string>
#include <string_view>

namespace base {

std::string printable(std::string_view text);

// A JSON string: control characters by their codes, bytes that are no UTF-8 as in printable().
std::string quoted_json(const std::string& text);

// Text, and bytes, inside of HTML and SVG.
std::string escaped(const std::string& text);
std::string base64(const std::string& bytes);

// The beginning of it for a message: what is longer (in bytes) is cut and ends in "...".
std::string excerpt(std::string_view text, size_t longest = 60);

}  // namespace base
