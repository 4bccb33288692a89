// SPDX-License-Identifier: BSD-3-Clause
// Text in parts, and how it ends.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace base {

// At white space: "a  b" is a, b.
std::vector<std::string> split_words(const std::string& text);

// At a separator; empty parts are left out: "a,,b" is a, b.
std::vector<std::string> split_list(const std::string& text, char separator);

bool begins_with(std::string_view text, std::string_view beginning);
bool ends_with(std::string_view text, std::string_view ending);

}  // namespace base
