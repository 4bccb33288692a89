// SPDX-License-Identifier: BSD-3-Clause
// See swayed_measure.h.
#include "comfort/swayed_measure.h"

#include <algorithm>
#include <optional>

#include "comfort/detect.h"
#include "comfort/swayed_rammg.h"
#include "comfort/swayed_sources.h"

namespace comfort {
namespace {

bool at_once(const Meter& meter) {
    const Settings& s = meter.settings();
    const bool whole_rows = s.rammg_area == RammgArea::view || s.rammg_area == RammgArea::rectangle;
    return sources_at_once(s) && !meter.needs().medians && (whole_rows || !meter.needs().rammg);
}

GreyPicture mean_of(const Swayed& s) {
    return {s.width, s.height, std::vector<float>(s.mean, s.mean + size_t(s.width) * size_t(s.height))};
}

OffAtEye off_at_eye(const Swayed& s, const Geometry& g) {
    MoreLight light(false);
    SwayedRow row(s.width);
    for (int r = 0; r < s.height; ++r) {
        row.show(s, r, g.extent(r));
        light.add(row, g, r);
    }
    return light.off_at_eye();
}

}  // namespace

SwayedMeasurements measure(const Swayed& lum, const Calmed& bright, const Luminance& mean, const Measurement& of_mean,
                           Meter& meter, const std::function<void(int)>& make_row) {
    if (!at_once(meter)) {
        for (int r = 0; r < lum.height; ++r) make_row(r);
        return measure_one_by_one(lum, bright, mean, of_mean, meter);
    }
    const Geometry& g = meter.geometry();
    const Settings& settings = meter.settings();
    SwayedMeasurements out{std::vector<Measurement>(size_t(lum.count()), of_mean), {}, of_mean, {}};
    const bool mean_counts =
        meter.needs().mean || settings.background == 1 || (settings.threshold && *settings.threshold <= 100);
    MoreLight light(mean_counts);
    std::optional<SwayedContrast> contrast;
    if (meter.needs().rammg) contrast.emplace(meter.pyramid(), *lum.signs);
    const bool all_columns = contrast && settings.rammg_area == RammgArea::rectangle;
    SwayedRow rows[2]{SwayedRow(g.width), SwayedRow(g.width)};
    for (int r = 0; r < g.height; ++r) {  // while they are in the cache
        SwayedRow& here = rows[r % 2];
        make_row(r);
        here.show(lum, r, all_columns ? Span{0, g.width} : g.extent(r));
        light.add(here, g, r);
        if (contrast) contrast->take(here, rows[(r + 1) % 2], r);
    }
    out.off_at_eye = light.off_at_eye();
    std::array<double, Signs::most> rammg{};
    if (contrast) rammg = contrast->of_pictures();
    const auto more = light.of_pictures(*lum.signs);
    std::array<float, Signs::most> brightest{};
    if (meter.needs().brightest) brightest = lum.brightest(g);
    std::vector<double> thresholds;
    for (size_t k = 0; k < out.own.size(); ++k) {
        Measurement& m = out.own[k];
        m.not_finite = m.negative = 0;
        m.ev += cdm2_per_grey * more[k].eye;
        m.mean_lum += cdm2_per_grey * more[k].all / g.omega_sum;
        m.max_lum = cdm2_per_grey * brightest[k];
        m.rammg = rammg[k];
        m.task_lum = float(m.mean_lum);
        thresholds.push_back(m.threshold = source_threshold(settings, false, m.task_lum));
    }
    if (!meter.needs().sources) return out;
    thresholds.push_back(of_mean.threshold);
    const double lowest = *std::min_element(thresholds.begin(), thresholds.end());
    const auto& found = meter.finder().runs();
    const auto bright_in_mean = lowest == of_mean.threshold ? found : bright_runs(mean, g, lowest);
    auto sources = all_sources(lum, bright, thresholds, bright_in_mean, g, settings, meter.finder().connector());
    for (size_t k = 0; k < out.own.size(); ++k) {
        meter.set_sources(std::move(sources[k].own), out.own[k]);
        out.of_mean.push_back(of_mean);
        meter.set_sources(std::move(sources[k].of_mean), out.of_mean.back());
    }
    meter.set_sources(std::move(sources.back().of_mean), out.calm);
    return out;
}

SwayedMeasurements measure_one_by_one(const Swayed& lum, const Calmed& bright, const Luminance& mean,
                                      const Measurement& of_mean, Meter& meter) {
    const bool sources = meter.needs().sources;
    SwayedMeasurements out{{}, {}, of_mean, off_at_eye(lum, meter.geometry())};
    GreyPicture picture, bright_picture;
    if (sources) {
        picture = mean_of(lum), bright_picture = bright.mean();
        Luminance grey = picture.luminance(), bright_in = bright_picture.luminance();
        out.calm = meter.measure(grey, "", &bright_in);
    }
    for (int k = 0; k < lum.count(); ++k) {
        lum.picture(k, picture);
        if (sources) bright.picture(k, bright_picture);
        Luminance grey = picture.luminance(), bright_in = bright_picture.luminance();
        out.own.push_back(meter.measure(grey, "", sources ? &bright_in : nullptr));
        if (sources) out.of_mean.push_back(meter.with_last_sources(mean, bright_in, of_mean));
    }
    return out;
}

void add_regions(const Swayed& lum, const Meter& meter, std::vector<Measurement>& own) {
    GreyPicture picture;
    for (int k = 0; k < lum.count(); ++k) {
        lum.picture(k, picture);
        own[size_t(k)].region_values = meter.measure_regions(picture.luminance()).region_values;
    }
}

}  // namespace comfort
