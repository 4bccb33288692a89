// SPDX-License-Identifier: BSD-3-Clause
// What swayed pictures measure: all of them at once wherever settings and metrics allow, else one after the other.
#pragma once
#include <functional>
#include <vector>
#include "comfort/calmed.h"
#include "comfort/measure.h"
#include "comfort/swayed_row.h"

namespace comfort {

struct SwayedMeasurements {
    std::vector<Measurement> own;      // of each picture
    std::vector<Measurement> of_mean;  // of the mean picture, with the source pixels of each
    Measurement calm;                  // of the mean picture, with those of the mean of `bright`
    OffAtEye off_at_eye;
};

// bright: which pixels are sources is decided in its pictures, where the meter finds any.  mean, and of_mean: the
// picture that has been measured last, and what it measured.  make_row: called with each row of `lum` and `bright`, in
// their order, before it is looked at.
SwayedMeasurements measure(
    const Swayed& lum, const Calmed& bright, const Luminance& mean, const Measurement& of_mean, Meter& meter,
    const std::function<void(int)>& make_row = [](int) {});
// The same by Meter alone, a picture at a time.
SwayedMeasurements measure_one_by_one(const Swayed& lum, const Calmed& bright, const Luminance& mean,
                                      const Measurement& of_mean, Meter& meter);
// Not without regions, which are measured in each picture by itself.
void add_regions(const Swayed& lum, const Meter& meter, std::vector<Measurement>& own);

}  // namespace comfort
