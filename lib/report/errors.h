// SPDX-License-Identifier: BSD-3-Clause
// The column `errors` at the end of a row: a word NAME=ERROR/DEGREES for each of its numbers whose error is known, the
// standard error and its degrees of freedom.  Limits of any certainty follow from them; .lo and .hi are of one.
// NAME=ERROR/DEGREES/HALVES/STRATA has the half-samples, too (uncertainty/halves.h): a letter each, and how many
// strata.
#pragma once
#include <optional>
#include <string>

#include "uncertainty/halves.h"

namespace report {

struct NumberError {
    double error = 0, degrees = 0;
    uncertainty::Halves halves = {};
};

constexpr const char* errors_column = "errors";
// Rows with the same word have their paths in common: SHARED_PATHS=, seeds and frames of their pictures.
constexpr const char* paths_column = "paths";
// "3/2600": of the hours that were to be rendered this is the third.
constexpr const char* hour_column = "hour";

// Adds the word of a number; none if its error is nan.
void add_error(const std::string& name, const NumberError& error, std::string& cell);
// Throws Error (place) for a word that is none.
std::optional<NumberError> error_of(const std::string& name, const std::string& cell, const std::string& place);

}  // namespace report
