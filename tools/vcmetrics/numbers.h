// SPDX-License-Identifier: BSD-3-Clause
// A number of a row: a value with its interval and its error.
#pragma once
#include "glare/columns.h"
#include "options.h"
#include "report/errors.h"
#include "uncertainty/estimate.h"

// A value, and the interval around `middle`, which may be another one.
struct Number {
    double value, middle;
    uncertainty::Interval off;  // nan: none
    report::NumberError error;  // likewise
};

// Of a column with this value in the picture of so many frames.
Number number_of(const Options& options, const glare::Column& column, const uncertainty::Estimate& estimate,
                 double value, int64_t frame);
Number difference_of(const Options& options, const uncertainty::Estimate& difference);
// Of a picture without values.
Number unknown_number(const glare::Column& column);
