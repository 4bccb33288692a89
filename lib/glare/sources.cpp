// SPDX-License-Identifier: BSD-3-Clause
// Groups of bright pixels, smoothed, without their peaks, split at zones: the glare sources (sources.h).
#include "glare/sources.h"
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "glare/position_index.h"
#include "glare/smooth.h"
#include "glare/threshold.h"
#include "glare/zones.h"

namespace glare {
namespace {

// Restores picture order and joins neighbours of a group again.
template <class GroupPixel>
std::vector<Run> to_runs(std::vector<GroupPixel> pixels, int width) {
    std::sort(pixels.begin(), pixels.end(), [](const GroupPixel& a, const GroupPixel& b) { return a.pixel < b.pixel; });
    std::vector<Run> runs;
    for (const GroupPixel& p : pixels) {
        if (!runs.empty() && runs.back().group == p.group && runs.back().start + runs.back().length == p.pixel &&
            p.pixel % width != 0)
            ++runs.back().length;
        else runs.push_back({p.pixel, 1, p.group});
    }
    return runs;
}

// Sets the centre of a source and the quantities that depend on it.
void place(GlareSource& s, const Geometry& g, const Settings& settings, bool inside_pixel) {
    if (inside_pixel) {
        const auto at = g.projector.direction((s.x + .5) / g.width, (s.y + .5) / g.height);
        s.direction = at ? *at : g.direction(int(s.x), int(s.y));
    } else {
        // the pixel of the centre narrowed to float (90.99999999999 becomes 91), as in evalglare
        s.direction = g.direction(int(float(s.x)), int(float(s.y)));
    }
    s.P = position_index(g, s.direction, settings.position);
    s.sigma_deg = s.theta_deg = eye_angles(g, s.direction).sigma_deg;
}

}  // namespace

SourceFinder::SourceFinder(const Geometry& geometry, const Settings& settings)
    : geometry_(geometry), settings_(settings), radius_px_(radius_in_pixels(geometry, settings.search_opening)) {
    if (settings.patches && geometry.projector.view().type != 'a')
        base::fail("-z", "patches need an angular fisheye view (-vta)");
}

double SourceFinder::reference_luminance(const Luminance& lum, double mean_lum) const {
    return settings_.task ? task_luminance(lum, geometry_, *settings_.task) : mean_lum;
}

PixelStatistics SourceFinder::statistics(const std::vector<uint32_t>& pixels, const Luminance& lum) const {
    return statistics_of(
        pixels, [&](size_t p) { return lum.at(p); }, geometry_);
}

std::vector<SourceFinder::GroupPixel> SourceFinder::column_order() const {
    const Geometry& g = geometry_;
    std::vector<GroupPixel> out;
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            out.push_back({uint32_t(g.x_of(p)) * uint32_t(g.height) + uint32_t(g.y_of(p)), p, r.group});
    std::sort(out.begin(), out.end(),
              [](const GroupPixel& a, const GroupPixel& b) { return a.column_key < b.column_key; });
    return out;
}

ConnectedSources::ConnectedSources(const Geometry& geometry, const Settings& settings)
    : SourceFinder(geometry, settings), components_(geometry, double(float(settings.search_opening)) / 2) {}

void ConnectedSources::find_groups(const Luminance& lum, const Luminance& classification_image, double threshold) {
    extra_.clear();
    zone_of_group_.clear();
    runs_ = bright_runs(classification_image, geometry_, threshold);
    if (settings_.patches) groups_ = assign_patches(runs_, geometry_, *settings_.patches);
    else groups_ = components_.label(runs_, 1);
    for (const Run& r : runs_) groups_ = std::max(groups_, r.group);
    if (settings_.smooth && searches()) smooth();
    if (settings_.peaks && searches()) extract_peaks(classification_image);
    direct_lux_ = light_of_groups(lum);
}

double ConnectedSources::light_of_groups(const Luminance& lum) const {
    double lux = 0;
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            lux += lum.at(p) * lum.filled(p) * geometry_.omega_cos[p];
    return lux;
}

void ConnectedSources::smooth() {
    const std::vector<Joining> joining = glare::smooth(runs_, geometry_, float(radius_px_ / 1.75));
    for (size_t k = 0; k < joining.size(); ++k) {
        const Joining& j = joining[k];
        const bool last_of_pixel = k + 1 == joining.size() || joining[k + 1].pixel != j.pixel;
        (last_of_pixel ? runs_ : extra_).push_back({j.pixel, 1, j.group});
    }
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
}

// Pixels at or above the limit leave their group and form new groups, connected by the same radius.
void ConnectedSources::extract_peaks(const Luminance& lum) {
    double brightest = 0;
    std::vector<float> group_max(groups_ + 1, 0);
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            group_max[r.group] = std::max(group_max[r.group], lum.grey[p]);
    for (float m : group_max) brightest = std::max(brightest, cdm2_per_grey * m);
    if (!(brightest > settings_.peak_limit)) return;
    const auto is_peak = [&](uint32_t p) { return lum.at(p) >= settings_.peak_limit; };
    const uint32_t before = groups_;
    std::vector<std::vector<Run>> peaks(before + 1);
    std::vector<Run> rest;
    for (const Run& r : runs_) {
        if (!(cdm2_per_grey * group_max[r.group] >= settings_.peak_limit)) {
            rest.push_back(r);
            continue;
        }
        for (uint32_t p = r.start, end = r.start + r.length; p < end;) {
            const uint32_t begin = p;
            const bool peak = is_peak(p);
            while (p < end && is_peak(p) == peak) ++p;
            (peak ? peaks[r.group] : rest).push_back({begin, p - begin, r.group});
        }
    }
    for (uint32_t group = 1; group <= before; ++group) {
        groups_ += components_.label(peaks[group], groups_ + 1);
        rest.insert(rest.end(), peaks[group].begin(), peaks[group].end());
    }
    std::sort(rest.begin(), rest.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
    runs_.swap(rest);
}

// Pixels inside a zone leave their group: one new group for each pair of old group and zone.
void ConnectedSources::split_zones() {
    const ZoneBorders borders(geometry_, *settings_.zones);
    std::vector<GroupPixel> pixels = column_order();
    std::vector<uint32_t> moved(2 * (groups_ + 1), 0);
    zone_of_group_.assign(groups_ + 1, 0);
    for (GroupPixel& p : pixels) {
        const int zone = borders.zone_of(p.pixel);
        if (!zone) continue;
        uint32_t& target = moved[2 * p.group + (zone - 1)];
        if (!target) {
            target = ++groups_;
            zone_of_group_.push_back(zone);
        }
        p.group = target;
    }
    runs_before_zones_ = runs_;
    runs_ = to_runs(std::move(pixels), geometry_.width);
}

std::vector<GlareSource> ConnectedSources::split(const Luminance& lum) {
    if (settings_.zones) split_zones();
    const Geometry& g = geometry_;
    std::vector<GlareSource> sources(groups_ + 1);
    const auto add = [&](const Run& r, bool at_eye) {
        GlareSource s = sources[r.group];
        const int y = g.y_of(r.start);
        int x = g.x_of(r.start);
        for (uint32_t p = r.start; p < r.start + r.length; ++p, ++x) {
            const double L = lum.at(p), share = lum.filled(p), omega = share * g.omega[p], power = L * omega;
            s.omega += omega, s.lum += power;
            s.x += power * (x + lum.right(p)), s.y += power * (y + lum.up(p));
            s.brightest = std::max(s.brightest, L);
            if (at_eye) s.eye_lux += L * share * g.omega_cos[p];
        }
        s.pixels += r.length;
        sources[r.group] = s;
    };
    for (const Run& r : runs_) add(r, true);
    for (const Run& r : extra_) add(r, false);
    for (GlareSource& s : sources) s.x /= s.lum, s.y /= s.lum, s.lum /= s.omega;
    std::vector<GlareSource> live;
    for (uint32_t group = 1; group <= groups_; ++group) {
        GlareSource& s = sources[group];
        if (!(s.pixels > 0)) continue;
        s.group = group;
        if (!zone_of_group_.empty()) s.zone = zone_of_group_[group];
        place(s, g, settings_, lum.share != nullptr);
        live.push_back(s);
    }
    return live;
}

}  // namespace glare
