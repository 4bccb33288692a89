// SPDX-License-Identifier: BSD-3-Clause
// Estimates of columns: wires pictures and metrics to lib/uncertainty.
// A rule that stops as soon as an interval is narrow selects looks whose error is underestimated: an estimate has the
// larger of the errors of its look and of the look before, carried to the same number of frames (from 16 frames on).
#pragma once
#include <vector>
#include "glare/columns.h"
#include "image/parts.h"
#include "uncertainty/estimator.h"
#include "uncertainty/halves.h"

namespace report {

// The way in which the error of a column is estimated.
uncertainty::Quantity quantity_of(glare::Noise noise);
std::vector<uncertainty::Quantity> quantities_of(const std::vector<glare::Column>& columns);

// The values measured in a picture and in its replicates.
struct Look {
    uncertainty::Replicates replicates;
    std::vector<uncertainty::Estimate> own, estimates;  // by itself, and with the look before; empty: there was none
    const uncertainty::Estimate& estimate(size_t column) const;  // nan: none
};

// The half-samples of a column, if its error is estimated by them; else of no strata.
uncertainty::Halves halves_of(const Look& look, size_t column, glare::Noise noise);

// measurement: of the mean that was read.
Look look(const glare::Reading& mean, const glare::Measurement& measurement, const std::vector<glare::Column>& columns,
          const std::vector<image::Part>& parts, const uncertainty::Frame0Error& frame0_error, const Look& before);

// The pixels that are measured.
std::vector<bool> counts(const glare::Geometry& geometry);

}  // namespace report
