// SPDX-License-Identifier: BSD-3-Clause
// Groups of bright pixels, smoothed, without their peaks, split at zones: the glare sources (sources.h).
#include "glare/sources.h"
#include <algorithm>
#include "base/error.h"
#include "glare/position_index.h"
#include "glare/smooth.h"
#include "glare/threshold.h"
#include "glare/zones.h"

namespace glare {
namespace {

// Groups of bright pixels by number, from 1.
struct Groups {
    std::vector<Run> runs;
    std::vector<Run> extra;  // pixels that smoothing adds to a second group
    std::vector<int> zones;  // by number; empty without zones
    uint32_t count = 0;      // highest number used
};

// Restores picture order and joins neighbours of a group again.
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

Groups bright_groups(const Luminance& lum, const Geometry& g, const Settings& settings, double threshold,
                     const ConnectedComponents& components) {
    Groups out;
    out.runs = bright_runs(lum, g, threshold);
    if (settings.patches) out.count = assign_patches(out.runs, g, *settings.patches);
    else out.count = components.label(out.runs, 1);
    for (const Run& r : out.runs) out.count = std::max(out.count, r.group);
    return out;
}

double light_of_runs(const std::vector<Run>& runs, const Luminance& lum, const Geometry& g) {
    double lux = 0;
    for (const Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) lux += lum.at(p) * lum.filled(p) * g.omega_cos[p];
    return lux;
}

void smooth_groups(Groups& groups, const Geometry& g, double radius_px) {
    const std::vector<Joining> joining = smooth(groups.runs, g, float(radius_px / 1.75));
    for (size_t k = 0; k < joining.size(); ++k) {
        const Joining& j = joining[k];
        const bool last_of_pixel = k + 1 == joining.size() || joining[k + 1].pixel != j.pixel;
        (last_of_pixel ? groups.runs : groups.extra).push_back({j.pixel, 1, j.group});
    }
    std::sort(groups.runs.begin(), groups.runs.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
}

// Pixels at or above the limit leave their group and form new groups, connected by the same radius.
void extract_peaks(Groups& groups, const Luminance& lum, double peak_limit, const ConnectedComponents& components) {
    double brightest = 0;
    std::vector<float> group_max(groups.count + 1, 0);
    for (const Run& r : groups.runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            group_max[r.group] = std::max(group_max[r.group], lum.grey[p]);
    for (float m : group_max) brightest = std::max(brightest, cdm2_per_grey * m);
    if (!(brightest > peak_limit)) return;
    const auto is_peak = [&](uint32_t p) { return lum.at(p) >= peak_limit; };
    const uint32_t before = groups.count;
    std::vector<std::vector<Run>> peaks(before + 1);
    std::vector<Run> rest;
    for (const Run& r : groups.runs) {
        if (!(cdm2_per_grey * group_max[r.group] >= peak_limit)) {
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
        groups.count += components.label(peaks[group], groups.count + 1);
        rest.insert(rest.end(), peaks[group].begin(), peaks[group].end());
    }
    std::sort(rest.begin(), rest.end(), [](const Run& a, const Run& b) { return a.start < b.start; });
    groups.runs.swap(rest);
}

// Pixels inside a zone leave their group: one new group for each pair of old group and zone.
void split_zones(Groups& groups, const Geometry& g, const Zones& zones) {
    const ZoneBorders borders(g, zones);
    std::vector<GroupPixel> pixels = column_order(groups.runs, g);
    std::vector<uint32_t> moved(2 * (groups.count + 1), 0);
    groups.zones.assign(groups.count + 1, 0);
    for (GroupPixel& p : pixels) {
        const int zone = borders.zone_of(p.pixel);
        if (!zone) continue;
        uint32_t& target = moved[2 * p.group + (zone - 1)];
        if (!target) {
            target = ++groups.count;
            groups.zones.push_back(zone);
        }
        p.group = target;
    }
    groups.runs = to_runs(std::move(pixels), g.width);
}

std::vector<GlareSource> sums_of(const Groups& groups, const Luminance& lum, const Geometry& g,
                                 const Settings& settings) {
    std::vector<GlareSource> sources(groups.count + 1);
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
    for (const Run& r : groups.runs) add(r, true);
    for (const Run& r : groups.extra) add(r, false);
    for (GlareSource& s : sources) s.x /= s.lum, s.y /= s.lum, s.lum /= s.omega;
    std::vector<GlareSource> live;
    for (uint32_t group = 1; group <= groups.count; ++group) {
        GlareSource& s = sources[group];
        if (!(s.pixels > 0)) continue;
        s.group = group;
        if (!groups.zones.empty()) s.zone = groups.zones[group];
        place(s, g, settings, lum.share != nullptr);
        live.push_back(s);
    }
    return live;
}

SetStatistics statistics_of(const PixelSets& sets, const Luminance& lum, const Geometry& g) {
    const auto of = [&](const std::optional<std::vector<uint32_t>>& pixels) {
        const auto at = [&](size_t p) { return lum.at(p); };
        return pixels ? std::optional(statistics_of(*pixels, at, g)) : std::nullopt;
    };
    return {of(sets.band), of(sets.mask), of(sets.zone1), of(sets.zone2)};
}

}  // namespace

std::vector<GroupPixel> column_order(const std::vector<Run>& runs, const Geometry& g) {
    std::vector<GroupPixel> out;
    for (const Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p)
            out.push_back({uint32_t(g.x_of(p)) * uint32_t(g.height) + uint32_t(g.y_of(p)), p, r.group});
    std::sort(out.begin(), out.end(),
              [](const GroupPixel& a, const GroupPixel& b) { return a.column_key < b.column_key; });
    return out;
}

Sources find_sources(const Luminance& lum, const Luminance& classification_image, const Geometry& g,
                     const ConnectedComponents& components, const Settings& settings, double threshold,
                     const PixelSets& sets) {
    const double radius_px = radius_in_pixels(g, settings.search_opening);
    Groups groups = bright_groups(classification_image, g, settings, threshold, components);
    if (settings.smooth && radius_px >= 1) smooth_groups(groups, g, radius_px);
    if (settings.peaks && radius_px >= 1) extract_peaks(groups, classification_image, settings.peak_limit, components);
    Sources out;
    out.direct_lux = light_of_runs(groups.runs, lum, g);
    out.sets = statistics_of(sets, lum, g);
    if (settings.zones) {
        out.runs_before_zones = groups.runs;
        split_zones(groups, g, *settings.zones);
    }
    out.sources = sums_of(groups, lum, g, settings);
    out.runs = std::move(groups.runs);
    return out;
}

}  // namespace glare
