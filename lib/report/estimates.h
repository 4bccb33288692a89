// SPDX-License-Identifier: BSD-3-Clause
// Estimates of columns for a growing sum of frames: wires pictures and metrics to lib/uncertainty.
// A look is due after 2, 3, 4, 6, 8, 11, 16, 23 ... frames; it measures the picture and its replicates.
// A rule that stops as soon as an interval is narrow selects looks whose error is underestimated: an estimate has the
// larger of the errors of its look and of the look before, carried to the same number of frames (from 16 frames on).
#pragma once
#include <memory>
#include <optional>
#include <vector>
#include "glare/columns.h"
#include "image/parts.h"
#include "uncertainty/estimator.h"

namespace report {

// How the error of a column is estimated.
uncertainty::Quantity quantity_of(glare::Noise noise);

class ColumnEstimates {
public:
    ColumnEstimates(const glare::PictureAnalyzer& analyzer, const std::vector<glare::Column>& columns);

    void restart();          // another sum begins
    void columns_changed();  // their estimates are those of the next look, which is due
    // L'(n), and the seed of its frames.
    void add(const glare::Luminance& mean, int64_t n, std::optional<uint64_t> seed = {});
    void take(const std::vector<image::Part>& all);  // the parts of a whole sum
    bool due() const { return parts().size() >= 2 && (again_ || frames() >= next_look_); }
    void look(const glare::Luminance& lum, const glare::Measurement& m);  // the mean of all, and what it measures
    void pass_look();                                                     // without looking

    int64_t frames() const { return image::frames_of(parts()); }
    const std::vector<image::Part>& parts() const { return taken_.empty() ? growing_.parts() : taken_; }
    const uncertainty::Estimate& estimate(size_t column) const { return estimates_[column]; }
    const uncertainty::Replicates& replicates() const { return replicates_; }  // of the last look
    std::vector<uncertainty::Quantity> quantities() const;                     // of all columns

private:
    std::vector<bool> counts() const;
    void find_frame0_error();
    uncertainty::Values values(const glare::Measurement& m, bool regions_alone) const;
    const glare::PictureAnalyzer& analyzer_;
    const std::vector<glare::Column>& columns_;
    image::GrowingParts growing_;
    std::vector<image::Part> taken_;
    std::vector<float> frame0_error_;                     // empty: not known
    std::vector<uncertainty::Estimate> own_, estimates_;  // of the last look by itself, and with the look before
    uncertainty::Replicates replicates_;
    int64_t next_look_ = 0;
    bool again_ = false;  // a look beside those that are due after some frames
};

}  // namespace report
