// SPDX-License-Identifier: BSD-3-Clause
// See estimates.h.
#include "report/estimates.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "base/processors.h"
#include "base/threads.h"
#include "uncertainty/frame0.h"
#include "uncertainty/threshold_filter.h"

namespace report {
namespace {

using glare::Noise;
using uncertainty::NoiseBias;
using Method = uncertainty::Quantity::Method;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Frames from which intervals of metrics hold that few sources decide: below four strata, too few half-samples show
// what a pixel at the threshold changes.
constexpr int64_t least_for_sources = 8;

// The error of a bias is the share of it that intervals needed to hold the truth (docs/decisions/0019-intervals.md).
const std::pair<Noise, uncertainty::Quantity> quantities[] = {
    {Noise::bias_alone, {Method::none, NoiseBias::variance, 0, false}},
    {Noise::linear, {Method::half_samples, NoiseBias::none, 0, false}},
    {Noise::dgp, {Method::half_samples, NoiseBias::variance, .25, false}},
    {Noise::glare, {Method::half_samples, NoiseBias::variance, .5, false, least_for_sources}},
    {Noise::contrast, {Method::none, NoiseBias::deviation, 0, false}},
    {Noise::region, {Method::jackknife, NoiseBias::none, 0, false}},
    {Noise::region_ratio, {Method::jackknife, NoiseBias::none, 0, true}},
};

// Pixels to each side of the threshold filter's neighbourhood, which is not wider than evalglare's search radius.
int filter_radius(const glare::Geometry& g) {
    constexpr double widest_rad = 0.1;
    const double pitch = std::sqrt(g.omega_sum / double(std::max(1L, g.valid_count)));
    return std::min(uncertainty::ThresholdFilter::largest_radius, int(widest_rad / (2 * pitch)));
}

glare::Luminance as_luminance(const std::vector<float>& grey, const glare::Geometry& g,
                              const image::Moments& moments = {}) {
    glare::Luminance lum;
    lum.moments = moments;
    lum.width = g.width, lum.height = g.height, lum.grey = grey.data();
    return lum;
}

uncertainty::Values values(const std::vector<glare::Column>& columns, const glare::Measurement& m,
                           bool regions_alone = false) {
    uncertainty::Values out;
    for (const glare::Column& c : columns)
        out.push_back(regions_alone && quantity_of(c.noise).method != Method::jackknife ? nan : c.value(m));
    return out;
}

// v + e (up: 1) or v - e (-1); below 0 there is none.
image::Moments moved(const std::vector<float>& moments, int pair, float up) {
    std::vector<float> out = moments;
    for (size_t i = 0; i < out.size(); i += image::moment_numbers) {
        const auto sign = float(uncertainty::random_sign(uint32_t(i / image::moment_numbers), pair));
        float& v = out[i + image::moment_variance];
        v = std::max(0.0f, v + up * sign * out[i + image::moment_difference]);
    }
    return std::make_shared<const std::vector<float>>(std::move(out));
}

constexpr int moment_pairs = 4;

// The error that columns of filled pixels (filled.h) have from that of the variance inside of pixels, which is
// estimated once, in frame 0: the same in all replicates of frames.
// Each pixel's variance has a known error e (image/moments.h).  Pairs of measurements with variances v + e and v - e,
// with a random sign for each pixel, give the column's error: the mean square of half their differences (balanced
// repeated replication with random signs; Wolter, Introduction to Variance Estimation, 2007, chapter 3).  Two values of
// each column from each pair, 0 for columns that are not of filled pixels; empty: none is known.
std::vector<uncertainty::Values> moment_values(const glare::Reading& whole, const glare::Measurement& measured,
                                               const std::vector<glare::Column>& columns) {
    const image::Moments& moments = whole.lum.moments;
    const auto of_filled = [](const glare::Column& c) { return c.of_filled; };
    if (!moments || std::none_of(columns.begin(), columns.end(), of_filled)) return {};
    std::vector<uncertainty::Values> seen(2 * moment_pairs);
    std::atomic<size_t> next{0};
    base::on_threads(std::min(base::processors(), unsigned(seen.size())), [&] {
        glare::Measurement m = measured;
        for (size_t k = next++; k < seen.size(); k = next++) {
            glare::Luminance here = whole.lum;
            here.moments = moved(*moments, int(k / 2), k % 2 ? -1 : 1);
            if (m.filled) m.filled = glare::measure_filled(whole, here, measured);
            for (const glare::Column& c : columns) seen[k].push_back(c.of_filled ? c.value(m) : 0);
        }
    });
    return seen;
}

}  // namespace

uncertainty::Quantity quantity_of(Noise noise) {
    for (const auto& [of, quantity] : quantities)
        if (of == noise) return quantity;
    return {};
}

std::vector<uncertainty::Quantity> quantities_of(const std::vector<glare::Column>& columns) {
    std::vector<uncertainty::Quantity> out;
    for (const glare::Column& c : columns) out.push_back(quantity_of(c.noise));
    return out;
}

const uncertainty::Estimate& Look::estimate(size_t column) const {
    static const uncertainty::Estimate none{nan, nan, 0, 0, false, 0};
    return column < estimates.size() ? estimates[column] : none;
}

uncertainty::Halves halves_of(const Look& look, size_t column, Noise noise) {
    if (look.replicates.half_samples.empty() || quantity_of(noise).method != Method::half_samples) return {};
    std::vector<double> values;
    for (const uncertainty::Values& v : look.replicates.half_samples) values.push_back(v[column]);
    return uncertainty::halves_of(values, uncertainty::degrees_of_freedom(look.replicates.frames));
}

std::vector<bool> counts(const glare::Geometry& g) {
    std::vector<bool> out(g.omega.size());
    for (size_t i = 0; i < out.size(); ++i) out[i] = g.valid(i);
    return out;
}

Look look(const glare::Reading& whole, const glare::Measurement& m, const std::vector<glare::Column>& columns,
          const std::vector<image::Part>& parts, const uncertainty::Frame0Error& frame0_error, const Look& before) {
    const glare::Geometry& g = whole.geometry();
    const uncertainty::GrowingMean mean{g.width, g.height, whole.lum.grey, &parts, frame0_error, counts(g)};

    uncertainty::Metrics metrics;
    metrics.quantities = quantities_of(columns);
    metrics.measure = [&] {
        return [&](std::vector<float>& image, std::vector<float>& classification) {
            return values(columns, glare::measure(whole, as_luminance(image, g, whole.lum.moments),
                                                  as_luminance(classification, g)));
        };
    };
    metrics.measure_regions = [&](std::vector<float>& image) {
        return values(columns, glare::measure_regions(whole, as_luminance(image, g)), true);
    };
    if (whole.plan().requirements & glare::require::sources)
        metrics.threshold = float(m.threshold / glare::cdm2_per_grey);
    metrics.filter_radius = filter_radius(g);
    Look out;
    out.replicates = uncertainty::replicate(mean, metrics, values(columns, m));
    out.replicates.lasting_pairs = moment_values(whole, m, columns);
    out.own = out.estimates = uncertainty::estimate(out.replicates, metrics.quantities);
    for (size_t c = 0; c < before.own.size(); ++c) {
        const double carried = before.own[c].error_after(out.own[c].frames);
        const bool filled = before.own[c].frames >= int64_t(image::most_parts);
        if (filled && carried > out.own[c].error) out.estimates[c].error = carried;
    }
    return out;
}

}  // namespace report
