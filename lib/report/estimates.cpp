// SPDX-License-Identifier: BSD-3-Clause
// See estimates.h.
#include "report/estimates.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "report/moment_error.h"
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

glare::Luminance as_luminance(std::vector<float>& grey, const glare::Geometry& g, const image::Moments& moments = {}) {
    glare::Luminance lum;
    lum.moments = moments;
    lum.width = g.width, lum.height = g.height, lum.grey = grey.data();
    return lum;
}

}  // namespace

uncertainty::Quantity quantity_of(Noise noise) {
    for (const auto& [of, quantity] : quantities)
        if (of == noise) return quantity;
    return {};
}

ColumnEstimates::ColumnEstimates(const glare::PictureAnalyzer& analyzer, const std::vector<glare::Column>& columns)
    : analyzer_(analyzer), columns_(columns) {
    restart();
}

void ColumnEstimates::restart() {
    growing_.restart();
    taken_.clear(), frame0_error_.clear();
    columns_changed();
    next_look_ = 2, again_ = false;
}

void ColumnEstimates::columns_changed() {
    own_.clear();
    estimates_.assign(columns_.size(), {nan, nan, 0, 0, false, 0});
    again_ = true;
}

void ColumnEstimates::add(const glare::Luminance& mean, int64_t n, std::optional<uint64_t> seed) {
    growing_.add(mean.grey, mean.size(), n, seed);
    if (n <= image::direct_samples) find_frame0_error();
}

std::vector<bool> ColumnEstimates::counts() const {
    std::vector<bool> out(analyzer_.geometry().omega.size());
    for (size_t i = 0; i < out.size(); ++i) out[i] = analyzer_.geometry().valid(i);
    return out;
}

void ColumnEstimates::take(const std::vector<image::Part>& all) {
    taken_ = all;
    find_frame0_error();
}

// From frames 1 to 8, as long as each is a part by itself.
void ColumnEstimates::find_frame0_error() {
    std::vector<image::Part> first = parts();
    first.resize(std::min(first.size(), size_t(image::direct_samples)));
    for (size_t k = 0; k < first.size(); ++k) {
        const image::SeedRanges& from = first[k].from;
        if (first[k].frames != 1 || from.empty() || from[0].second[0].first != int64_t(k) + 1) return;
    }
    const glare::Geometry& g = analyzer_.geometry();
    if (first.size() > 2) frame0_error_ = uncertainty::frame0_error(first, g.width, g.height, counts());
}

void ColumnEstimates::pass_look() {
    constexpr double growth_between_looks = 1.41421356;
    again_ = false;
    if (frames() < next_look_) return;
    next_look_ = std::max(frames() + 1, int64_t(std::llround(double(frames()) * growth_between_looks)));
}

uncertainty::Values ColumnEstimates::values(const glare::Measurement& m, bool regions_alone) const {
    uncertainty::Values out;
    for (const glare::Column& c : columns_)
        out.push_back(regions_alone && quantity_of(c.noise).method != Method::jackknife ? nan : c.value(m));
    return out;
}

std::vector<uncertainty::Quantity> ColumnEstimates::quantities() const {
    std::vector<uncertainty::Quantity> out;
    for (const glare::Column& c : columns_) out.push_back(quantity_of(c.noise));
    return out;
}

void ColumnEstimates::look(const glare::Luminance& lum, const glare::Measurement& m) {
    pass_look();
    const glare::Geometry& g = analyzer_.geometry();
    uncertainty::GrowingMean mean{lum.width, lum.height, lum.grey, &parts(), nullptr, counts()};
    if (!frame0_error_.empty()) mean.frame0_error = &frame0_error_;

    uncertainty::Metrics metrics;
    metrics.quantities = quantities();
    metrics.measure = [&] {
        return [this, &g, &lum](std::vector<float>& image, std::vector<float>& classification) {
            glare::Luminance own = as_luminance(image, g, lum.moments),
                             classification_image = as_luminance(classification, g);
            return values(analyzer_.measure(own, &image == &classification ? own : classification_image), false);
        };
    };
    metrics.measure_regions = [&](std::vector<float>& image) {
        return values(analyzer_.measure_regions(as_luminance(image, g)), true);
    };
    if (analyzer_.requires_sources()) metrics.threshold = float(m.threshold / glare::cdm2_per_grey);
    metrics.filter_radius = filter_radius(g);
    const std::vector<uncertainty::Estimate> before = std::move(own_);
    replicates_ = uncertainty::replicate(mean, metrics, values(m, false));
    replicates_.lasting_pairs = moment_values(analyzer_, columns_, lum);
    own_ = uncertainty::estimate(replicates_, metrics.quantities);
    estimates_ = own_;
    for (size_t c = 0; c < before.size(); ++c) {
        const double carried = before[c].error_after(own_[c].frames);
        const bool filled = before[c].frames >= int64_t(image::most_parts);
        if (filled && carried > own_[c].error) estimates_[c].error = carried;
    }
}

}  // namespace report
