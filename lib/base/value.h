// SPDX-License-Identifier: BSD-3-Clause
// A word as a number, read in one way wherever a person types one: "-2", ".5", "1e3", also where a whole number is
// meant, and "50%" where a share of a whole is.
#pragma once
#include <string>

namespace base {

// The whole text as a finite number, or an Error that names the place: "-vh: "abc" is not a number".
double to_real(const std::string& text, const std::string& where);

// The same, and "50%" is 0.5.
double parse_fraction(const std::string& text, const std::string& where);

// A whole number; "1e3" is one.
long to_int(const std::string& text, const std::string& where);

// The shortest text that reads as the same number: "0.2", "1e-6".
std::string number_text(double value);

}  // namespace base
