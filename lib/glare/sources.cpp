// SPDX-License-Identifier: BSD-3-Clause
// Groups of bright pixels, smoothed, without their peaks, split at zones: the glare sources (sources.h).
#include "glare/sources.h"
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "glare/detect.h"
#include "glare/smooth.h"

namespace glare {
namespace {

struct GroupPixel {
    uint32_t column_key, pixel, group;
};

// All pixels of the runs, columns from the left, in a column from the bottom: evalglare's order.
std::vector<GroupPixel> column_order(const std::vector<Run>& runs, const Geometry& g) {
    std::vector<GroupPixel> out;
    for (const Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            out.push_back({uint32_t(g.x_of(p)) * uint32_t(g.height) + uint32_t(g.y_of(p)), p, r.group});
    std::sort(out.begin(), out.end(),
              [](const GroupPixel& a, const GroupPixel& b) { return a.column_key < b.column_key; });
    return out;
}

// Back to picture order, neighbours of a group joined again.
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

}  // namespace

SourceFinder::SourceFinder(const Geometry& geometry, const Settings& settings)
    : geometry_(geometry),
      settings_(settings),
      radius_px_(radius_in_pixels(geometry, settings.search_opening)),
      connector_(geometry, double(float(settings.search_opening)) / 2) {
    if (settings.patches && geometry.projector.view().type != 'a')
        base::fail("-z", "patches need an angular fisheye view (-vta)");
    if (settings.slips) as_evalglare_ = std::make_unique<EvalglareGroups>(geometry, settings.search_opening);
}

std::vector<GlareSource> SourceFinder::find(const Luminance& lum, double threshold) {
    find_groups(lum, lum, threshold);
    return split(lum);
}

void SourceFinder::find_groups(const Luminance& lum, const Luminance& bright_in, double threshold) {
    extra_.clear();
    zone_of_group_.clear();
    slipped_eye_lux_.clear();
    runs_ = bright_runs(bright_in, geometry_, threshold);
    groups_ = settings_.patches ? assign_patches(runs_, geometry_, *settings_.patches) : 0;
    if (settings_.slips || settings_.check_picture) check_.emplace(lum, settings_.check_picture);
    if (check_ && settings_.task && settings_.task_painted) paint_task();
    if (as_evalglare_) {
        connect_as_evalglare();
    } else {
        if (!settings_.patches) groups_ = connector_.connect(runs_, 1);
        for (const Run& r : runs_) groups_ = std::max(groups_, r.group);
        if (settings_.smooth && radius_px_ >= 1) smooth();
        if (settings_.peaks && radius_px_ >= 1) extract_peaks(bright_in);
    }
    direct_lux_ = light_of_groups(lum);
    if (check_) paint_sources();
}

// Where the whole picture is a source, evalglare's background is what rounding leaves of two sums of the same light: so
// columns, and products taken in its order.
double SourceFinder::light_of_groups(const Luminance& lum) const {
    const Geometry& g = geometry_;
    double lux = 0;
    if (as_evalglare_) {
        const Vec3 forward = g.line_of_sight();
        for (const GroupPixel& p : column_order(runs_, g))
            lux += 179 * g.omega[p.pixel] * (check_->grey(p.pixel) * dot(forward, g.direction(p.pixel)));
    } else {
        for (const Run& r : runs_)
            for (uint32_t p = r.start; p < r.start + r.length; ++p) lux += lum.at(p) * lum.filled(p) * g.omega_cos[p];
    }
    return lux;
}

std::vector<GlareSource> SourceFinder::split(const Luminance& lum) {
    before_zones_.clear();
    if (settings_.zones) {
        if (settings_.slips) before_zones_ = sums(lum);
        split_zones(lum);
    }
    return sums(lum);
}

void SourceFinder::paint_task() {
    const Vec3 centre = geometry_.direction(settings_.task->x, settings_.task->y);
    const double limit = inside_cosine(float(settings_.task->opening));
    for (size_t i = 0; i < geometry_.omega.size(); ++i)
        if (geometry_.valid(i) && inside(dot(centre, geometry_.direction(i)), limit, settings_.slips))
            check_->paint(i, task_paint);
}

// The fast modes keep what the first scan found; so does a search radius of at most a pixel.
void SourceFinder::connect_as_evalglare() {
    EvalglareGroups& groups = *as_evalglare_;
    const bool wide = radius_px_ > 1;
    if (settings_.patches) groups.take(runs_, groups_, *check_);
    else groups.find(runs_, *check_, wide, wide && !settings_.fast);
    runs_ = groups.runs();
    if (settings_.smooth && radius_px_ >= 1) smooth();
    if (settings_.peaks && radius_px_ >= 1) groups.extract_peaks(*check_, settings_.peak_limit);
    runs_ = groups.runs();
    groups_ = groups.count();
}

void SourceFinder::paint_sources() {
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            check_->paint(p, settings_.source_paint.value_or(source_paint(r.group)));
}

void SourceFinder::paint_band(const std::vector<uint32_t>& pixels) {
    if (!check_) return;
    for (const uint32_t p : pixels) check_->paint(p, band_paint);
}

void SourceFinder::smooth() {
    const std::vector<Joining> joining = glare::smooth(runs_, geometry_, float(radius_px_ / 1.75));
    for (size_t k = 0; k < joining.size(); ++k) {
        const Joining& j = joining[k];
        const bool last_of_pixel = k + 1 == joining.size() || joining[k + 1].pixel != j.pixel;
        (last_of_pixel ? runs_ : extra_).push_back({j.pixel, 1, j.group});
        if (as_evalglare_ && last_of_pixel) as_evalglare_->add(j.pixel, j.group, *check_);
        else if (as_evalglare_) as_evalglare_->count_too(j.pixel, j.group, *check_);
    }
    std::sort(runs_.begin(), runs_.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
}

// Pixels at or above the limit leave their group and form new ones, connected by the same radius.
void SourceFinder::extract_peaks(const Luminance& lum) {
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
        groups_ += connector_.connect(peaks[group], groups_ + 1);
        rest.insert(rest.end(), peaks[group].begin(), peaks[group].end());
    }
    std::sort(rest.begin(), rest.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
    runs_.swap(rest);
}

// Pixels inside a zone leave their group: one new group for each old group and zone.
void SourceFinder::split_zones(const Luminance& lum) {
    const Geometry& g = geometry_;
    const Zones& zones = *settings_.zones;
    const Vec3 centre = g.direction(zones.inner.x, zones.inner.y);
    const double inner = inside_cosine(zones.inner.opening),
                 outer = zones.outer_opening ? inside_cosine(*zones.outer_opening) : 2;
    std::vector<GroupPixel> pixels = column_order(runs_, g);
    std::vector<uint32_t> moved(2 * (groups_ + 1), 0);
    zone_of_group_.assign(groups_ + 1, 0);
    if (settings_.slips) {
        slipped_eye_lux_.assign(groups_ + 1, 0);
        for (const GroupPixel& p : pixels) slipped_eye_lux_[p.group] += lum.at(p.pixel) * g.omega_cos[p.pixel];
    }
    for (GroupPixel& p : pixels) {
        const double c = dot(centre, g.direction(p.pixel));
        const int zone = inside(c, inner, settings_.slips) ? 1 : inside(c, outer, settings_.slips) ? 2 : 0;
        if (!zone) continue;
        uint32_t& target = moved[2 * p.group + (zone - 1)];
        if (!target) {
            target = as_evalglare_ ? as_evalglare_->open() : groups_ + 1;
            groups_ = target;
            zone_of_group_.push_back(zone);
            if (settings_.slips) slipped_eye_lux_.push_back(0);
        }
        if (check_) check_->paint(p.pixel, zone_paint[zone - 1]);
        if (settings_.slips) {  // evalglare credits the newest group, and removes what it has painted
            const double lux = check_->at(p.pixel) * g.omega_cos[p.pixel];
            slipped_eye_lux_[p.group] -= lux;
            slipped_eye_lux_.back() += lux;
            as_evalglare_->leave(p.pixel, *check_);
            as_evalglare_->join(p.pixel, target, *check_);
        }
        p.group = target;
    }
    runs_ = to_runs(std::move(pixels), g.width);
    if (settings_.check_picture) paint_zones(centre, inner, outer);
}

// Sources in zones have their colour when they are split; this is the rest.
void SourceFinder::paint_zones(const Vec3& centre, double inner, double outer) {
    std::vector<bool> source(geometry_.omega.size());
    for (const Run& r : runs_) std::fill_n(source.begin() + r.start, r.length, true);
    for (size_t i = 0; i < source.size(); ++i) {
        if (source[i] || !geometry_.valid(i)) continue;
        const double c = dot(centre, geometry_.direction(i));
        const int zone = inside(c, inner, settings_.slips) ? 1 : inside(c, outer, settings_.slips) ? 2 : 0;
        if (zone) check_->paint(i, zone_paint[zone - 1]);
    }
}

std::vector<GlareSource> SourceFinder::sums(const Luminance& lum) const {
    const Geometry& g = geometry_;
    std::vector<GlareSource> sources(groups_ + 1);
    if (as_evalglare_) {
        for (uint32_t group = 1; group <= groups_; ++group) {
            const GroupSums& s = as_evalglare_->sums()[group];
            GlareSource& to = sources[group];
            to.pixels = s.pixels, to.omega = s.omega, to.lum = s.lum;
            to.x = s.x, to.y = s.y, to.brightest = s.brightest;
        }
        for (const Run& r : runs_)
            for (uint32_t p = r.start; p < r.start + r.length; ++p)
                sources[r.group].eye_lux += lum.at(p) * g.omega_cos[p];
    } else {
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
    }
    std::vector<GlareSource> live;
    for (uint32_t group = 1; group <= groups_; ++group) {
        GlareSource& s = sources[group];
        if (!(s.pixels > 0)) continue;
        s.group = group;
        if (!zone_of_group_.empty()) s.zone = zone_of_group_[group];
        if (!slipped_eye_lux_.empty()) s.eye_lux = slipped_eye_lux_[group];
        place(s, g, settings_, lum.share != nullptr);
        // evalglare leaves the angle as it was, of the source before, where the centre's pixel has no direction.
        if (settings_.slips && length(s.direction) == 0) s.sigma_deg = live.empty() ? 0 : live.back().sigma_deg;
        live.push_back(s);
    }
    return live;
}

}  // namespace glare
