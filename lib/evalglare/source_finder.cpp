// SPDX-License-Identifier: BSD-3-Clause
// evalglare's order of work: scan, smooth, extract peaks, paint, split at zones (source_finder.h).
#include "evalglare/source_finder.h"
#include <algorithm>
#include <cmath>
#include "base/angle.h"
#include "base/error.h"
#include "evalglare/check_picture.h"
#include "evalglare/groups.h"
#include "evalglare/rounded_geometry.h"
#include "glare/position_index.h"
#include "glare/smooth.h"
#include "glare/threshold.h"
#include "glare/zones.h"

namespace evalglare {

using glare::GlareSource;
using glare::Luminance;

namespace {

// One picture's sources, in evalglare's order of work.
class SourceFinder {
public:
    SourceFinder(const Geometry& geometry, const glare::Settings& settings, const Settings& own, const Luminance& lum)
        : geometry_(geometry),
          settings_(settings),
          own_(own),
          radius_px_(glare::radius_in_pixels(geometry, settings.search_opening)),
          groups_(geometry, settings.search_opening),
          check_(lum, false) {}
    glare::Sources find(const Luminance& lum, const Luminance& classification_image, double threshold,
                        const glare::PixelSets& sets) {
        runs_ = bright_runs(classification_image, geometry_, threshold);
        const uint32_t patches = settings_.patches ? assign_patches(runs_, geometry_, *settings_.patches) : 0;
        if (settings_.task && own_.task_painted) paint_task(check_, geometry_, *settings_.task);
        connect(patches);
        glare::Sources out;
        out.direct_lux = own_.fast == 2 ? own_.fast_direct : light_of_groups();
        paint_sources(check_, runs_, own_);
        if (sets.band) {
            out.sets.band = statistics(*sets.band);
            paint_band(check_, *sets.band);
        }
        if (sets.mask) out.sets.mask = statistics(*sets.mask);
        if (sets.zone1) out.sets.zone1 = statistics(*sets.zone1);
        if (sets.zone2) out.sets.zone2 = statistics(*sets.zone2);
        if (settings_.zones) {
            out.before_zones = sums(lum);
            out.runs_before_zones = runs_;
            split_zones(lum);
        }
        out.sources = sums(lum);
        out.runs = std::move(runs_);
        return out;
    }

private:
    bool searches() const { return radius_px_ >= 1; }  // the search radius is at least a pixel
    // The fast modes keep what the first scan found; so does a search radius of at most a pixel.
    void connect(uint32_t patches) {
        const bool wide = radius_px_ > 1;
        if (settings_.patches) groups_.take(runs_, patches, check_);
        else groups_.find(runs_, check_, wide, wide && !own_.fast);
        runs_ = groups_.runs();
        if (settings_.smooth && searches()) smooth();
        if (settings_.peaks && searches()) groups_.extract_peaks(check_, settings_.peak_limit);
        runs_ = groups_.runs();
    }
    void smooth() {
        const std::vector<glare::Joining> joining = glare::smooth(runs_, geometry_, float(radius_px_ / 1.75));
        for (size_t k = 0; k < joining.size(); ++k) {
            const glare::Joining& j = joining[k];
            const bool last_of_pixel = k + 1 == joining.size() || joining[k + 1].pixel != j.pixel;
            if (last_of_pixel) groups_.add(j.pixel, j.group, check_);
            else groups_.count_too(j.pixel, j.group, check_);
        }
    }
    // If the whole picture is a source, evalglare's background is the rounding difference of two sums of the same
    // light: therefore columns, and products in its order.
    double light_of_groups() const {
        const Geometry& g = geometry_;
        const Vec3 forward = g.line_of_sight();
        double lux = 0;
        for (const glare::GroupPixel& p : glare::column_order(runs_, g))
            lux += 179 * g.omega[p.pixel] * (check_.grey(p.pixel) * dot(forward, g.direction(p.pixel)));
        return lux;
    }
    // Pixels inside a zone leave their group: one new group for each old group and zone.  evalglare credits the newest
    // group with their light, and removes from the old one what it has painted.
    void split_zones(const Luminance& lum) {
        const glare::ZoneBorders borders(geometry_, *settings_.zones);
        const std::vector<glare::GroupPixel> pixels = glare::column_order(runs_, geometry_);
        std::vector<uint32_t> moved(2 * (groups_.count() + 1), 0);
        zone_of_group_.assign(groups_.count() + 1, 0);
        zoned_eye_lux_.assign(groups_.count() + 1, 0);
        for (const glare::GroupPixel& p : pixels)
            zoned_eye_lux_[p.group] += lum.at(p.pixel) * geometry_.omega_cos[p.pixel];
        for (const glare::GroupPixel& p : pixels) {
            const int zone = borders.zone_of(p.pixel);
            if (!zone) continue;
            uint32_t& target = moved[2 * p.group + (zone - 1)];
            if (!target) {
                target = groups_.open();
                zone_of_group_.push_back(zone);
                zoned_eye_lux_.push_back(0);
            }
            check_.paint(p.pixel, zone_paint[zone - 1]);
            const double lux = check_.at(p.pixel) * geometry_.omega_cos[p.pixel];
            zoned_eye_lux_[p.group] -= lux;
            zoned_eye_lux_.back() += lux;
            groups_.leave(p.pixel, check_);
            groups_.join(p.pixel, target, check_);
        }
        runs_ = groups_.runs();
    }
    // A deviation that rounding carries below 0 is not a number.
    glare::PixelStatistics statistics(const std::vector<uint32_t>& pixels) const {
        glare::PixelStatistics s = statistics_of(
            pixels, [&](size_t p) { return check_.at(p); }, geometry_);
        if (!pixels.empty()) s.deviation = std::sqrt(s.variance);
        return s;
    }
    std::vector<GlareSource> sums(const Luminance& lum) const {
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

    const Geometry& geometry_;
    const glare::Settings& settings_;
    const Settings& own_;
    const double radius_px_;
    Groups groups_;
    CheckPicture check_;
    std::vector<Run> runs_;
    std::vector<int> zone_of_group_;     // by group number, empty without zones
    std::vector<double> zoned_eye_lux_;  // by group number, after zones have split them; else empty
};

// Columns from the left, each from the bottom.  The fast modes (-1, -2) know the picture by its external illuminance
// alone.
glare::Photometry photometry(const Luminance& lum, const Geometry& g, const glare::Settings& settings,
                             const Settings& own) {
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
    if (own.fast) out.ev = settings.external_ev.value_or(0), out.mean_lum = 0;
    return out;
}

// The fast modes look at pixels outside the view as well.
double reference_luminance(const Luminance& lum, const Geometry& g, const glare::Settings& settings, double mean_lum,
                           const Settings& own) {
    if (settings.task) return glare::task_luminance(lum, g, *settings.task, own.fast != 0);
    return own.fast ? settings.external_ev.value_or(0) / (2 * base::pi) : mean_lum;
}

}  // namespace

glare::Methods methods(const Settings& own) {
    glare::Methods out;
    out.geometry = [](const view::View& view, const std::string& place) {
        if (view.vl != 0)
            base::warn(place,
                       "the view has a lift (-vl): solid angles are evalglare's, which are of the mirrored rows");
        return std::make_unique<RoundedGeometry>(view);
    };
    out.photometry = [own](const Luminance& lum, const Geometry& g, const glare::Settings& settings) {
        return photometry(lum, g, settings, own);
    };
    out.reference_luminance = [own](const Luminance& lum, const Geometry& g, const glare::Settings& settings,
                                    double mean_lum) { return reference_luminance(lum, g, settings, mean_lum, own); };
    out.sources = [own](const Geometry&, const glare::Settings& settings) -> glare::FindSources {
        return [own, settings](const Luminance& lum, const Luminance& classification_image, const Geometry& g,
                               double threshold, const glare::PixelSets& sets) {
            return SourceFinder(g, settings, own, lum).find(lum, classification_image, threshold, sets);
        };
    };
    out.nothing_left = [](double rest, double) { return rest == 0; };
    return out;
}

}  // namespace evalglare
