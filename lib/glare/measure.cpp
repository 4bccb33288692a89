// SPDX-License-Identifier: BSD-3-Clause
// What is asked for is worked out once, in the order in which the metrics need each other (measure.h).
#include "glare/measure.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "glare/detect.h"
#include "glare/evalglare_format.h"

namespace glare {

using base::pi;

Meter::Meter(const Settings& settings, const Needs& needs, std::optional<image::MaskSet> regions,
             image::DrawRegions draw)
    : settings_(settings), needs_(needs), regions_(std::move(regions)), draw_(std::move(draw)) {
    if (regions_)
        for (const image::Mask& m : regions_->masks) region_names_.push_back(m.name);
    if (!settings_.task_region.empty() &&
        std::find(region_names_.begin(), region_names_.end(), settings_.task_region) == region_names_.end())
        base::fail("-task", "there is no region \"" + settings_.task_region + "\"");
}

void Meter::prepare(const view::View& view, const image::Picture& picture, const std::string& place) {
    if (geometry_ && geometry_->fits(view, picture.width, picture.height)) return;
    if (view.type == 'l') base::fail(place, "a parallel view (-vtl) has no eye point: glare is not defined for it");
    try {
        view::validate(view);
    } catch (const base::Error& e) {
        base::fail(place, std::string("the view cannot be used: ") + e.what());
    }
    if (draw_) regions_ = draw_(view, picture.width, picture.height);
    if (regions_ && (regions_->width != picture.width || regions_->height != picture.height))
        base::fail(place, "the picture has " + std::to_string(picture.width) + " x " + std::to_string(picture.height) +
                              " pixels, the regions " + std::to_string(regions_->width) + " x " +
                              std::to_string(regions_->height));
    if (settings_.slips && view.vl != 0)
        base::warn(place, "the view has a lift (-vl): the solid angles are evalglare's, those of the mirrored rows");
    finder_.reset();
    geometry_.reset();
    geometry_ = std::make_unique<Geometry>(view, picture.width, picture.height, settings_.slips);
    narrow_ = needs_.all_light && geometry_->share_of_light() < .9;
    finder_ = make_finder();
    if (needs_.rammg) pyramid_ = std::make_unique<Pyramid>(*geometry_, settings_.rammg_area);
    find_position_index();
    mask_.reset();
    region_pixels_.clear();
    if (regions_)
        for (const image::Mask& m : regions_->masks) region_pixels_.emplace_back(m.coverage, *geometry_);
}

void Meter::photometry(const Luminance& lum, Measurement& m) const {
    if (settings_.slips) return photometry_by_column(lum, m);
    const Geometry& g = *geometry_;
    const Light light = light_of(lum);
    float top[8] = {};
    for (int r = 0; r < g.height; ++r)
        for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s) {
            const float* row = lum.grey + size_t(r) * g.width;
            int x = g.spans[s].begin;
            for (; x + 8 <= g.spans[s].end; x += 8)
                for (int k = 0; k < 8; ++k) top[k] = std::max(top[k], row[x + k]);
            for (; x < g.spans[s].end; ++x) top[0] = std::max(top[0], row[x]);
        }
    m.ev = cdm2_per_grey * light.eye;
    m.omega = g.omega_sum;
    m.mean_lum = cdm2_per_grey * light.all / g.omega_sum;
    m.max_lum = cdm2_per_grey * *std::max_element(top, top + 8);
    m.valid_pixels = g.valid_count;
}

Light Meter::light_of(const Luminance& lum) const {
    const Geometry& g = *geometry_;
    Light sum{0, 0};
    for (int r = 0; r < g.height; ++r)
        for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s) {
            const size_t first = size_t(r) * g.width, end = first + g.spans[s].end;
            double e[4] = {}, f[4] = {};
            size_t i = first + g.spans[s].begin;
            for (; i + 4 <= end; i += 4)
                for (int k = 0; k < 4; ++k) {
                    e[k] += lum.grey[i + k] * g.omega_cos[i + k];
                    f[k] += lum.grey[i + k] * g.omega[i + k];
                }
            for (; i < end; ++i) {
                e[0] += lum.grey[i] * g.omega_cos[i];
                f[0] += lum.grey[i] * g.omega[i];
            }
            sum.eye += (e[0] + e[1]) + (e[2] + e[3]);
            sum.all += (f[0] + f[1]) + (f[2] + f[3]);
        }
    return sum;
}

// The same in evalglare's order: columns from the left, each from the bottom.  See SourceFinder::light_of_groups.
void Meter::photometry_by_column(const Luminance& lum, Measurement& m) const {
    const Geometry& g = *geometry_;
    double flux = 0;
    for (int x = 0; x < g.width; ++x)
        for (int y = 0; y < g.height; ++y) {
            const size_t i = g.index(x, y);
            if (!g.valid(i)) continue;
            const double L = lum.at(i);
            m.ev += L * g.omega_cos[i];
            flux += L * g.omega[i];
            m.omega += g.omega[i];
            m.max_lum = std::max(m.max_lum, L);
        }
    m.mean_lum = flux / m.omega;
    m.valid_pixels = g.valid_count;
}

void Meter::find_position_index() {
    const Geometry& g = *geometry_;
    position_index_.assign(needs_.medians ? g.omega.size() : 0, 0);
    for (size_t i = 0; i < position_index_.size(); ++i)
        if (g.valid(i)) position_index_[i] = float(position_index(g, g.seen_direction(i), settings_.position));
}

// Means and medians of L, L/P and L/P^2.  evalglare divides the last mean by the solid angle twice; so do we when
// its slips are asked for.
void Meter::position_statistics(const Luminance& lum, Measurement& m) const {
    const Geometry& g = *geometry_;
    std::vector<float> values;
    values.reserve(g.valid_count);
    double sum1 = 0, sum2 = 0;
    for (int power = 0; power <= 2; ++power) {
        values.clear();
        for (size_t i = 0; i < g.omega.size(); ++i) {
            if (!g.valid(i)) continue;
            const double P = position_index_[i], L = lum.at(i);
            values.push_back(float(power == 0 ? L : power == 1 ? L / P : L / (P * P)));
            if (power == 1) sum1 += g.omega[i] * L / P;
            if (power == 2) sum2 += g.omega[i] * L / (P * P);
        }
        (power == 0 ? m.median : power == 1 ? m.median_pos : m.median_pos2) = median(values);
    }
    m.mean_pos = sum1 / g.omega_sum;
    m.mean_pos2 = sum2 / g.omega_sum / (settings_.slips ? g.omega_sum : 1);
}

void Meter::background_and_dgp(double ev, double direct, Measurement& m) const {
    // Two sums over the same pixels, or nearly so; evalglare takes what rounding leaves.
    const bool all_is_source = !settings_.slips && std::fabs(ev - direct) < 1e-11 * ev;
    m.background0 = all_is_source ? 0 : (ev - direct) / evalglare_pi;
    m.background = m.background0;
    if (settings_.fast) {
        // Lb as by default, whatever -q says
    } else if (settings_.background == 1) {
        double flux = 0, omega = 0;
        for (const GlareSource& s : m.sources) flux += s.lum * s.omega, omega += s.omega;
        const double rest = m.omega - omega;
        const bool no_rest = settings_.slips ? rest == 0 : rest < 1e-11 * m.omega;
        m.background = no_rest ? m.mean_lum : (m.omega * m.mean_lum - flux) / rest;
    } else if (settings_.background == 2) {
        m.background = ev / evalglare_pi;
    }
    m.eye_lux_used = settings_.external_ev.value_or(ev);
    m.dgp_computed = dgp(m.glare, ev, settings_.constants);
    m.dgp = dgp(m.glare, m.eye_lux_used, settings_.constants) *
            (settings_.low_light ? low_light_factor(m.eye_lux_used) : 1);
}

void Meter::glare(Luminance& lum, Luminance& bright_in, SourceFinder& finder, Measurement& m) const {
    const Geometry& g = *geometry_;
    if (settings_.field_cut) cut_field(lum, g, settings_.field_cut);
    if (settings_.field_cut && &bright_in != &lum) cut_field(bright_in, g, settings_.field_cut);
    const bool has_task = settings_.task || !settings_.task_region.empty();
    // The fast modes know the picture by its external illuminance alone, and look at pixels outside the view as well.
    const double ev = settings_.fast ? settings_.external_ev.value_or(0) : m.ev;
    m.task_lum = settings_.fast ? ev / (2 * pi) : m.mean_lum;
    if (settings_.task) {
        m.task_lum = task_luminance(lum, g, *settings_.task, settings_.slips, settings_.fast != 0);
    } else {
        for (size_t k = 0; k < region_names_.size(); ++k)
            if (region_names_[k] == settings_.task_region) m.task_lum = region_pixels_[k].tal(lum);
    }
    m.task_lum = float(m.task_lum);
    m.threshold = source_threshold(settings_, has_task, m.task_lum);

    if (settings_.zones && (settings_.zones->inner.x < 0 || settings_.zones->inner.y < 0 ||
                            settings_.zones->inner.x >= g.width || settings_.zones->inner.y >= g.height))
        base::fail("-l", "the zone's centre is outside the picture");
    if (needs_.filled && lum.moments && !settings_.slips && !settings_.field_cut && !settings_.fill)
        m.filled = std::make_shared<const Measurement>(measure_filled(lum, bright_in, ev, finder, m));
    finder.find_groups(lum, bright_in, m.threshold);
    pixel_sets(lum, finder, m);
    m.sources = finder.split(lum);
    m.direct_lux = finder.direct_lux();
    m.glare = glare_terms(finder, lum, bright_in, settings_, m.threshold, m.sources);
    m.any_source = !m.sources.empty();
    background_and_dgp(ev, settings_.fast == 2 ? settings_.fast_direct : m.direct_lux, m);
    if (m.mask) m.pgsv = pgsv(*m.mask, settings_.fast ? 0 : m.mean_lum, ev, has_task, m.task_lum);
}

// Band, mask and zones, before zones take pixels out of sources.  evalglare reads them from its check picture, where
// sources and the band are painted by then.
void Meter::pixel_sets(const Luminance& lum, SourceFinder& finder, Measurement& m) const {
    const Geometry& g = *geometry_;
    const bool slips = settings_.slips;
    const auto at = [&](size_t p) { return slips ? finder.check_picture()->at(p) : lum.at(p); };
    if (settings_.band_rad) {
        const std::vector<uint32_t> band = band_pixels(g, *settings_.band_rad);
        m.band = statistics_of(band, at, g, slips);
        finder.paint_band(band);
    }
    if (mask_) m.mask = statistics_of(*mask_, at, g, slips);
    if (!settings_.zones) return;
    m.zone1 = statistics_of(zone_pixels(g, *settings_.zones, 1, slips), at, g, slips);
    if (settings_.zones->outer_opening)
        m.zone2 = statistics_of(zone_pixels(g, *settings_.zones, 2, slips), at, g, slips);
}

Luminance Meter::read(image::Picture& picture, const std::string& place, const std::optional<view::View>& view) {
    if (!view && !picture.header.view)
        base::fail(place, "the header has no view; give one with -vf file or with -vt, -vh and -vv");
    prepare(view ? *view : *picture.header.view, picture, place);
    if (geometry_->valid_count == 0) base::fail(place, "no pixel of the picture lies in its view");
    Luminance lum = make_luminance(picture);
    if (lum.not_finite)
        base::warn(place, "pixels that are not finite count as black (-metrics not_finite counts them)");
    if (needs_.filled && !lum.moments && !std::exchange(told_no_moments_, true))
        base::warn(place,
                   "has no moments of its pixels (a stream of ptrace and its OpenEXR files have): what their size does "
                   "to glare is not known");
    if (lum.negative) base::warn(place, "pixels are negative (-metrics negative counts them)");
    return lum;
}

Measurement Meter::measure(image::Picture& picture, const std::string& place, const std::optional<view::View>& view) {
    Luminance lum = read(picture, place, view);
    return measure(lum, place);
}

Measurement Meter::measure(Luminance& lum, const std::string& place) {
    std::optional<double> black_corners;
    if (geometry_->projector.view().type == 'v') {
        black_corners = black_corner_percent(lum);
        if (*black_corners > 70 && !settings_.force)
            throw Refusal(place,
                          "the view is perspective (-vtv) but " + std::to_string(int(*black_corners)) +
                              " % of the corners are black, as in a fisheye picture; correct the view with -vt, or "
                              "use -f to measure it all the same",
                          evalglare_black_corners(*black_corners, true));
    }
    if (std::exchange(narrow_, false))
        base::warn(place, "Ev and DGP are of this narrow view; -vta -vh 180 -vv 180 has all that reaches the eye");
    if (settings_.mask_file && needs_.sources && !mask_) mask_ = mask_pixels(*settings_.mask_file, *geometry_);
    Measurement m = measure(lum, lum, *finder_);
    m.black_corners = black_corners;
    return m;
}

Measurement Meter::measure(Luminance& lum, Luminance& bright_in, SourceFinder& finder) const {
    Measurement m;
    m.not_finite = lum.not_finite;
    m.negative = lum.negative;
    if (settings_.fill) fill_rows(lum, *geometry_, *settings_.fill);
    if (settings_.fill && &bright_in != &lum) fill_rows(bright_in, *geometry_, *settings_.fill);
    photometry(lum, m);
    regions(lum, m);
    if (needs_.rammg) m.rammg = rammg(lum, *pyramid_);
    if (needs_.medians) position_statistics(lum, m);
    if (needs_.sources) glare(lum, bright_in, finder, m);
    return m;
}

std::unique_ptr<SourceFinder> Meter::make_finder() const {
    return std::make_unique<SourceFinder>(*geometry_, settings_);
}

void Meter::regions(const Luminance& lum, Measurement& m) const {
    for (const RegionPixels& r : region_pixels_) {
        m.region_values.emplace_back();
        if (needs_.regions_in_full) m.region_values.back() = r.measure(lum);
        else m.region_values.back().tal = r.tal(lum);
    }
}

Measurement Meter::measure_regions(const Luminance& lum) const {
    Measurement m;
    regions(lum, m);
    return m;
}

}  // namespace glare
