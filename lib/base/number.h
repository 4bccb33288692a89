// SPDX-License-Identifier: BSD-3-Clause
// Numbers as RADIANCE's files and options write them, and nothing else:
//     integer  [+-]digits             real  [+-]digits[.digits][e[+-]digits]   (".5" and "5." too)
// so hexadecimal, "nan", "inf", "1e" and trailing letters are not numbers.
#pragma once
#include <string_view>

namespace base {

bool parse_integer(std::string_view word, long long& value);  // false also when it does not fit
bool parse_real(std::string_view word, double& value);        // false also on overflow; underflow gives 0

}  // namespace base
