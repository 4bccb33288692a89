// SPDX-License-Identifier: BSD-3-Clause
// evalglare's order of work: scan, smooth, extract peaks, paint, split at zones (source_finder.h).
#include "evalglare/source_finder.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "evalglare/rounded_geometry.h"
#include "glare/position_index.h"
#include "glare/smooth.h"
#include "glare/threshold.h"
#include "glare/zones.h"

namespace evalglare {

using glare::GlareSource;
using glare::Luminance;

SourceFinder::SourceFinder(const Geometry& geometry, const glare::Settings& settings, const Settings& own)
    : glare::SourceFinder(geometry, settings), own_(own), groups_(geometry, settings.search_opening) {}

// Columns from the left, each from the bottom.  The fast modes (-1, -2) know the picture by its external illuminance
// alone.
glare::Photometry SourceFinder::photometry(const Luminance& lum) const {
    const Geometry& g = geometry_;
    glare::Photometry out;
    double flux = 0;
    for (int x = 0; x < g.width; ++x)
        for (int y = 0; y < g.height; ++y) {
            const size_t i = g.index(x, y);
            if (!g.valid(i)) continue;
            const double L = lum.at(i);
            out.ev += L * g.omega_cos[i];
            flux += L * g.omega[i];
            out.omega += g.omega[i];
            out.max_lum = std::max(out.max_lum, L);
        }
    out.mean_lum = flux / out.omega;
    out.valid_pixels = g.valid_count;
    if (own_.fast) out.ev = settings_.external_ev.value_or(0), out.mean_lum = 0;
    return out;
}

// The fast modes look at pixels outside the view as well.
double SourceFinder::reference_luminance(const Luminance& lum, double mean_lum) const {
    if (settings_.task) return task_luminance(lum, geometry_, *settings_.task, own_.fast != 0);
    return own_.fast ? settings_.external_ev.value_or(0) / (2 * base::pi) : mean_lum;
}

void SourceFinder::find_groups(const Luminance& lum, const Luminance& classification_image, double threshold) {
    zone_of_group_.clear();
    zoned_eye_lux_.clear();
    sources_before_zones_.clear();
    runs_ = bright_runs(classification_image, geometry_, threshold);
    const uint32_t patches = settings_.patches ? assign_patches(runs_, geometry_, *settings_.patches) : 0;
    check_.emplace(lum, false);
    if (settings_.task && own_.task_painted) paint_task(*check_, geometry_, *settings_.task);
    connect(patches);
    direct_lux_ = own_.fast == 2 ? own_.fast_direct : light_of_groups();
    paint_sources(*check_, runs_, own_);
}

// The fast modes keep what the first scan found; so does a search radius of at most a pixel.
void SourceFinder::connect(uint32_t patches) {
    const bool wide = radius_px_ > 1;
    if (settings_.patches) groups_.take(runs_, patches, *check_);
    else groups_.find(runs_, *check_, wide, wide && !own_.fast);
    runs_ = groups_.runs();
    if (settings_.smooth && searches()) smooth();
    if (settings_.peaks && searches()) groups_.extract_peaks(*check_, settings_.peak_limit);
    runs_ = groups_.runs();
}

void SourceFinder::smooth() {
    const std::vector<glare::Joining> joining = glare::smooth(runs_, geometry_, float(radius_px_ / 1.75));
    for (size_t k = 0; k < joining.size(); ++k) {
        const glare::Joining& j = joining[k];
        const bool last_of_pixel = k + 1 == joining.size() || joining[k + 1].pixel != j.pixel;
        if (last_of_pixel) groups_.add(j.pixel, j.group, *check_);
        else groups_.count_too(j.pixel, j.group, *check_);
    }
}

// If the whole picture is a source, evalglare's background is the rounding difference of two sums of the same light:
// therefore columns, and products in its order.
double SourceFinder::light_of_groups() const {
    const Geometry& g = geometry_;
    const Vec3 forward = g.line_of_sight();
    double lux = 0;
    for (const GroupPixel& p : column_order())
        lux += 179 * g.omega[p.pixel] * (check_->grey(p.pixel) * dot(forward, g.direction(p.pixel)));
    return lux;
}

// A deviation that rounding carries below 0 is not a number.
glare::PixelStatistics SourceFinder::statistics(const std::vector<uint32_t>& pixels, const Luminance&) const {
    glare::PixelStatistics s = statistics_of(
        pixels, [&](size_t p) { return check_->at(p); }, geometry_);
    if (!pixels.empty()) s.deviation = std::sqrt(s.variance);
    return s;
}

void SourceFinder::mark_band(const std::vector<uint32_t>& pixels) { paint_band(*check_, pixels); }

std::vector<GlareSource> SourceFinder::split(const Luminance& lum) {
    if (settings_.zones) {
        sources_before_zones_ = sums(lum);
        runs_before_zones_ = runs_;
        split_zones(lum);
    }
    return sums(lum);
}

// Pixels inside a zone leave their group: one new group for each old group and zone.  evalglare credits the newest
// group with their light, and removes from the old one what it has painted.
void SourceFinder::split_zones(const Luminance& lum) {
    const glare::ZoneBorders borders(geometry_, *settings_.zones);
    const std::vector<GroupPixel> pixels = column_order();
    std::vector<uint32_t> moved(2 * (groups_.count() + 1), 0);
    zone_of_group_.assign(groups_.count() + 1, 0);
    zoned_eye_lux_.assign(groups_.count() + 1, 0);
    for (const GroupPixel& p : pixels) zoned_eye_lux_[p.group] += lum.at(p.pixel) * geometry_.omega_cos[p.pixel];
    for (const GroupPixel& p : pixels) {
        const int zone = borders.zone_of(p.pixel);
        if (!zone) continue;
        uint32_t& target = moved[2 * p.group + (zone - 1)];
        if (!target) {
            target = groups_.open();
            zone_of_group_.push_back(zone);
            zoned_eye_lux_.push_back(0);
        }
        check_->paint(p.pixel, zone_paint[zone - 1]);
        const double lux = check_->at(p.pixel) * geometry_.omega_cos[p.pixel];
        zoned_eye_lux_[p.group] -= lux;
        zoned_eye_lux_.back() += lux;
        groups_.leave(p.pixel, *check_);
        groups_.join(p.pixel, target, *check_);
    }
    runs_ = groups_.runs();
}

std::vector<GlareSource> SourceFinder::sums(const Luminance& lum) const {
    const Geometry& g = geometry_;
    std::vector<double> eye_lux(groups_.count() + 1, 0);
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) eye_lux[r.group] += lum.at(p) * g.omega_cos[p];
    std::vector<GlareSource> live;
    for (uint32_t group = 1; group <= groups_.count(); ++group) {
        const GroupSums& sum = groups_.sums()[group];
        if (!(sum.pixels > 0)) continue;
        GlareSource s;
        s.pixels = sum.pixels, s.omega = sum.omega, s.lum = sum.lum;
        s.x = sum.x, s.y = sum.y, s.brightest = sum.brightest;
        s.group = group;
        s.zone = zone_of_group_.empty() ? 0 : zone_of_group_[group];
        s.eye_lux = zoned_eye_lux_.empty() ? eye_lux[group] : zoned_eye_lux_[group];
        // The position index belongs to the pixel of the centre narrowed to float (90.99999999999 becomes 91), the
        // other directions to the pixel of the unrounded centre.
        s.P = position_index(g, g.seen_direction(int(float(s.x)), int(float(s.y))), settings_.position);
        s.direction = g.seen_direction(int(s.x), int(s.y));
        s.sigma_deg = s.theta_deg = eye_angles(g, s.direction).sigma_deg;
        // If the centre's pixel has no direction, evalglare keeps the angle of the source before.
        if (length(s.direction) == 0) s.sigma_deg = live.empty() ? 0 : live.back().sigma_deg;
        live.push_back(s);
    }
    return live;
}

glare::Methods methods(const Settings& settings) {
    glare::Methods out;
    out.geometry = [](const view::View& view, const std::string& place) {
        if (view.vl != 0)
            base::warn(place,
                       "the view has a lift (-vl): solid angles are evalglare's, which are of the mirrored rows");
        return std::make_unique<RoundedGeometry>(view);
    };
    out.finder = [settings](const Geometry& geometry, const glare::Settings& of_glare) {
        return std::make_unique<SourceFinder>(geometry, of_glare, settings);
    };
    return out;
}

}  // namespace evalglare
