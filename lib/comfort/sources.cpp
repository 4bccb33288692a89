// SPDX-License-Identifier: BSD-3-Clause
// Groups of bright pixels, smoothed, without their peaks, split at zones: the glare sources (sources.h).
#include "comfort/sources.h"
#include <algorithm>
#include <cmath>
#include "comfort/detect.h"

namespace comfort {
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

// Weighted means grown pixel by pixel, the way that gives evalglare's last digits; centres that are whole numbers
// fall to either side of a pixel border with them.
void add_running(Source& s, double L, double w, int x, int y) {
    const double power = s.lum * s.omega + L * w;
    s.x = (s.x * s.omega * s.lum + x * w * L) / power;
    s.y = (s.y * s.omega * s.lum + y * w * L) / power;
    s.lum = power / (s.omega + w);
    s.omega += w;
    s.pixels += 1;
    s.brightest = std::max(s.brightest, L);
}

void remove_running(Source& s, double L, double w, int x, int y) {
    const double power = s.lum * s.omega - L * w;
    s.x = (s.x * s.omega * s.lum - x * w * L) / power;
    s.y = (s.y * s.omega * s.lum - y * w * L) / power;
    s.lum = power / (s.omega - w);
    s.omega -= w;
    s.pixels -= 1;
}

}  // namespace

void SourceFinder::start_running(const Luminance& lum) {
    const Geometry& g = geometry_;
    running_.assign(groups_ + 1, Source());
    std::vector<Run> all = runs_;
    all.insert(all.end(), extra_.begin(), extra_.end());
    for (const GroupPixel& p : column_order(all, g))
        add_running(running_[p.group], lum.at(p.pixel), g.omega[p.pixel], g.x_of(p.pixel), g.y_of(p.pixel));
}

void SourceFinder::move_running(uint32_t from, uint32_t to, uint32_t pixel, const Luminance& lum) {
    const Geometry& g = geometry_;
    if (running_.size() <= to) running_.resize(to + 1);
    remove_running(running_[from], lum.at(pixel), g.omega[pixel], g.x_of(pixel), g.y_of(pixel));
    add_running(running_[to], lum.at(pixel), g.omega[pixel], g.x_of(pixel), g.y_of(pixel));
}

SourceFinder::SourceFinder(const Geometry& geometry, const Settings& settings)
    : geometry_(geometry),
      settings_(settings),
      radius_px_(radius_in_pixels(geometry, settings.search_opening)),
      connector_(geometry, double(float(settings.search_opening)) / 2) {}

std::vector<Source> SourceFinder::find(const Luminance& lum, double threshold) {
    extra_.clear();
    zone_of_group_.clear();
    slipped_eye_lux_.clear();
    runs_ = bright_runs(lum, geometry_, threshold);
    if (settings_.patches) {
        assign_patches(runs_, geometry_, *settings_.patches);
        groups_ = 0;
        for (const Run& r : runs_) groups_ = std::max(groups_, r.group);
    } else if (settings_.slips && radius_px_ <= 1) {
        groups_ = walk_groups(runs_, geometry_, settings_.search_opening);
    } else {
        groups_ = connector_.connect(runs_, 1);
    }
    if (settings_.smooth && radius_px_ >= 1) smooth(lum);
    if (settings_.slips) start_running(lum);
    if (settings_.peaks && radius_px_ >= 1) extract_peaks(lum);
    direct_lux_ = 0;
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) direct_lux_ += lum.at(p) * geometry_.omega_cos[p];
    before_zones_.clear();
    if (settings_.zones) {
        if (settings_.slips) before_zones_ = sums(lum);
        split_zones(lum);
    }
    return sums(lum);
}

// A dark pixel joins every group that holds more than a fifth of the solid angle within radius/1.75 pixels of it.
void SourceFinder::smooth(const Luminance&) {
    const Geometry& g = geometry_;
    const float reach = float(radius_px_ / 1.75);
    std::vector<uint32_t> label(g.omega.size(), 0), smoothed;
    for (const Run& r : runs_) std::fill_n(label.begin() + r.start, r.length, r.group);
    struct Share {
        uint32_t group;
        double omega;
    };
    std::vector<Share> shares;
    std::vector<GroupPixel> added;
    for (int x = 0; x < g.width; ++x)
        for (int y = 0; y < g.height; ++y) {
            const size_t i = g.index(x, y);
            if (!g.valid(i) || label[i]) continue;
            const int x0 = std::max(0, int(x - reach)), y0 = std::max(0, int(y - reach));
            int x1 = int(x + reach), y1 = int(y + reach);
            if (x1 > g.width - 1) x1 = g.width - 2;
            if (y1 > g.height - 1) y1 = g.height - 2;
            shares.clear();
            double all = 0;
            for (int xx = x0; xx <= x1; ++xx)
                for (int yy = y0; yy <= y1; ++yy) {
                    if (std::sqrt(double((xx - x) * (xx - x) + (yy - y) * (yy - y))) > reach) continue;
                    const size_t j = g.index(xx, yy);
                    const double w = std::fabs(g.omega[j]);
                    all += w;
                    if (!label[j]) continue;
                    auto s =
                        std::find_if(shares.begin(), shares.end(), [&](const Share& q) { return q.group == label[j]; });
                    if (s == shares.end()) shares.push_back({label[j], w});
                    else s->omega += w;
                }
            std::sort(shares.begin(), shares.end(), [](const Share& a, const Share& b) { return a.group < b.group; });
            uint32_t number = 0;
            for (const Share& s : shares)
                if (s.omega / all > 0.2) {
                    if (number) extra_.push_back({uint32_t(i), 1, number});
                    number = s.group;
                }
            if (number) added.push_back({0, uint32_t(i), number});
        }
    for (const GroupPixel& p : added) runs_.push_back({p.pixel, 1, p.group});
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
        if (settings_.slips)
            for (const GroupPixel& p : column_order(peaks[group], geometry_))
                move_running(group, p.group, p.pixel, lum);
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
            target = ++groups_;
            zone_of_group_.push_back(zone);
            if (settings_.slips) slipped_eye_lux_.push_back(0);
        }
        if (settings_.slips) {  // evalglare credits the newest group
            const double lux = lum.at(p.pixel) * g.omega_cos[p.pixel];
            slipped_eye_lux_[p.group] -= lux;
            slipped_eye_lux_.back() += lux;
            move_running(p.group, target, p.pixel, lum);
        }
        p.group = target;
    }
    runs_ = to_runs(std::move(pixels), g.width);
}

std::vector<Source> SourceFinder::sums(const Luminance& lum) const {
    const Geometry& g = geometry_;
    std::vector<Source> sources(groups_ + 1);
    if (settings_.slips) {
        std::copy(running_.begin(), running_.begin() + std::min(running_.size(), sources.size()), sources.begin());
    } else {
        const auto add = [&](const Run& r) {
            Source& s = sources[r.group];
            const int y = g.y_of(r.start);
            int x = g.x_of(r.start);
            for (uint32_t p = r.start; p < r.start + r.length; ++p, ++x) {
                const double L = lum.at(p), power = L * g.omega[p];
                s.omega += g.omega[p], s.lum += power, s.x += power * x, s.y += power * y;
                s.brightest = std::max(s.brightest, L);
            }
            s.pixels += r.length;
        };
        for (const Run& r : runs_) add(r);
        for (const Run& r : extra_) add(r);
        for (Source& s : sources) s.x /= s.lum, s.y /= s.lum, s.lum /= s.omega;
    }
    for (const Run& r : runs_)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) sources[r.group].eye_lux += lum.at(p) * g.omega_cos[p];

    std::vector<Source> live;
    for (uint32_t group = 1; group <= groups_; ++group) {
        Source& s = sources[group];
        if (!(s.pixels > 0)) continue;
        s.group = group;
        if (!zone_of_group_.empty()) s.zone = zone_of_group_[group];
        if (!slipped_eye_lux_.empty()) s.eye_lux = slipped_eye_lux_[group];
        // The position index belongs to the pixel of the centre narrowed to float (90.99999999999 becomes 91);
        // evalglare takes the other directions from the pixel of the unrounded centre, we only when told to.
        const Vec3 at = g.direction(int(float(s.x)), int(float(s.y)));
        s.P = position_index(g.projector, at, settings_.position);
        s.direction = settings_.slips ? g.direction(int(s.x), int(s.y)) : at;
        s.sigma_deg = eye_angles(g.projector, s.direction).sigma_deg;
        live.push_back(s);
    }
    return live;
}

std::vector<GlareSource> SourceFinder::every_pixel(const Luminance& lum, double threshold) const {
    std::vector<GlareSource> out;
    for (const Run& r : bright_runs(lum, geometry_, threshold))
        for (uint32_t p = r.start; p < r.start + r.length; ++p) {
            const Vec3 d = geometry_.direction(p);
            const double sigma = eye_angles(geometry_.projector, d).sigma_deg;
            out.push_back({lum.at(p), geometry_.omega[p], position_index(geometry_.projector, d, settings_.position),
                           sigma, lum.at(p) * geometry_.omega_cos[p], sigma});
        }
    return out;
}

}  // namespace comfort
