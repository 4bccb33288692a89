// SPDX-License-Identifier: BSD-3-Clause
// JSON text of strings and numbers.
#pragma once
#include <string>
#include <vector>

namespace live::json {
std::string text(const std::string& s);                   // quoted; bytes that are no UTF-8 become '?'
std::string number(double v);                             // as many digits as it takes; null where it is not finite
std::string list(const std::vector<std::string>& items);  // of texts
std::string numbers(const std::vector<double>& values);
}  // namespace live::json
