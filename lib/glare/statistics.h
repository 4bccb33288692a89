// SPDX-License-Identifier: BSD-3-Clause
// Statistics of sets of pixels: evalglare's bands (-B), zones (-l, -L) and masks (-A), and medians.  Pixels have equal
// weights, except in the mean.  std = sqrt(E[L^2] - E[L]^2); percentile p of n sorted values: the mean of entries int(n
// p) and int(n p - 1), as in evalglare.
#pragma once
#include <functional>
#include <vector>
#include "glare/geometry.h"
#include "glare/luminance.h"
#include "glare/settings.h"

namespace glare {

struct PixelStatistics {
    long pixels = 0;
    double omega = 0, mean = 0, median = 0, deviation = 0, p75 = 0, p95 = 0, lowest = 0, highest = 0, eye_lux = 0;
    double variance = 0;  // may be below 0 by rounding: then the deviation is 0
};

// `lum_at`: a pixel's luminance.
PixelStatistics statistics_of(const std::vector<uint32_t>& pixels, const std::function<double(size_t)>& lum_at,
                              const Geometry& geometry);

// Horizontal band: valid pixels within `half_rad` of the middle row's pixel of their column, and the middle row.
std::vector<uint32_t> band_pixels(const Geometry& geometry, double half_rad);
// Zone 1: inside the inner circle; zone 2: between the circles.
std::vector<uint32_t> zone_pixels(const Geometry& geometry, const Zones& zones, int zone);
// Valid pixels where a mask picture is brighter than 0.1 cd/m2; throws Error if the size differs.
std::vector<uint32_t> mask_pixels(const std::string& file, const Geometry& geometry);

double median(std::vector<float>&
                  values);  // middle value, mean of the two middle ones; the order is lost; nan if empty or one is

// Predicted glare sensation vote of a masked (daylight) area of mean luminance `mask`, solid angle `omega`.
struct Pgsv {
    double contrast, saturation, value;
};
Pgsv pgsv(const PixelStatistics& mask, double mean_lum, double ev, bool has_task, double task_lum);

}  // namespace glare
