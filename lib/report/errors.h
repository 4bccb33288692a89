// SPDX-License-Identifier: BSD-3-Clause
// The column `errors` at the end of a row: a word NAME=ERROR/DEGREES for each of its numbers whose error is known, the
// standard error and its degrees of freedom.  Limits of any certainty follow from them; .lo and .hi are of one.
#pragma once
#include <optional>
#include <string>

namespace report {

struct NumberError {
    double error = 0, degrees = 0;
};

constexpr const char* errors_column = "errors";

// Adds the word of a number; none if its error is nan.
void add_error(const std::string& name, const NumberError& error, std::string& cell);
// Throws Error (place) for a word that is none.
std::optional<NumberError> error_of(const std::string& name, const std::string& cell, const std::string& place);

}  // namespace report
