// SPDX-License-Identifier: BSD-3-Clause
// Short walks, by the cosine, tell the second moment of a path for any share.  A sample of light f, in a direction that
// has q times the cosine's density among those toward windows, counts f^2 / (1 - share + share q) (Veach 1997, section
// 9.2).  f is what the walk has met and a share of the light beyond, bounce by bounce, as if every place were like the
// mean of all.
#include "trace/window_share.h"

#include <algorithm>
#include <cmath>

namespace kernels {
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/portals.h"
}  // namespace kernels

namespace trace {
namespace {

using namespace kernels;

constexpr uint32_t EYE_SIDE = 48;  // walks from the eye, a square of so many
constexpr uint32_t WALKS = 8;      // from each place that the eye sees; from those that they reach, one
constexpr int STEPS = 8;           // shares looked at: 0, 1/8 .. 7/8

struct Place {
    float3 p, n;
};

struct Sample {
    double met, beyond;  // light, and the share of the light beyond
    double density;      // of directions toward windows, over the cosine's
};

double luminance(const float (&c)[3]) {
    const double v = luminance3(F3(c[0], c[1], c[2]));
    return std::isfinite(v) && v > 0 ? v : 0;
}

class Survey {
public:
    Survey(Device& device, const Params& par, const std::vector<float>& portals) : device_(device), par_(par) {
        par_.mode = MODE_WALK;
        par_.portals_at = 0;
        par_.portal_share = 0;
        windows_.f = portals.data();
        clear_ = 1e-4f * std::sqrt(portals[PORTAL_AREA]);
    }

    // The largest share under which the second moment is that of the cosine or less.  What is met through windows is
    // smooth, and many frames have it with less noise than single samples promise: so not the share of the least.
    float share() {
        look_around(look_around(seen(), WALKS), 1);
        if (samples_.empty()) return 0;
        const double plain = second_moment(0);
        int step = STEPS - 1;
        while (step > 0 && !(second_moment(double(step) / STEPS) <= plain)) step--;
        return float(step) / STEPS;
    }

private:
    Device& device_;
    Params par_;
    SceneTables windows_ = {};
    float clear_;  // rays begin so far from their surface
    std::vector<Sample> samples_;

    std::vector<WalkEnd> walk(const std::vector<WalkRay>& rays) {
        std::vector<WalkEnd> ends;
        par_.first = 0;
        par_.slots = uint32_t(rays.size());
        if (!rays.empty()) device_.walk(par_, rays, ends);
        par_.frame++;  // other random numbers for the next
        return ends;
    }

    static Place place_of(const WalkEnd& end) {
        return {F3(end.p[0], end.p[1], end.p[2]), F3(end.n[0], end.n[1], end.n[2])};
    }

    std::vector<Place> seen() {
        std::vector<WalkRay> rays;
        for (uint32_t i = 0; i < EYE_SIDE * EYE_SIDE; i++) {
            const float x = float(i % EYE_SIDE) + 0.5f, y = float(i / EYE_SIDE) + 0.5f;
            rays.push_back({{x / EYE_SIDE, y / EYE_SIDE, 0}, {0, 0, 0}, WALK_FROM_EYE});
        }
        std::vector<Place> places;
        for (const WalkEnd& end : walk(rays))
            if (end.bounce) places.push_back(place_of(end));
        return places;
    }

    // Samples by walks from each place; returns where they have come to.
    std::vector<Place> look_around(const std::vector<Place>& places, uint32_t walks) {
        std::vector<WalkRay> rays;
        std::vector<double> densities;
        for (uint32_t k = 0; k < places.size() * walks; k++) {
            const Place& place = places[k / walks];
            Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, k / walks, k % walks, 5);
            const float2 r = sample2(&rnd);
            const float3 dir = cosine_direction(place.n, r.x, r.y), org = madd3(place.n, clear_, place.p);
            rays.push_back({{org.x, org.y, org.z}, {dir.x, dir.y, dir.z}, FAR_AWAY});
            densities.push_back(density(place, dir));
        }

        std::vector<Place> reached;
        const std::vector<WalkEnd> ends = walk(rays);
        for (size_t k = 0; k < ends.size(); k++) {
            samples_.push_back(
                {luminance(ends[k].gathered), ends[k].bounce ? luminance(ends[k].share) : 0, densities[k]});
            if (ends[k].bounce) reached.push_back(place_of(ends[k]));
        }
        return reached;
    }

    // 1 where no window is to be seen: there directions go by the cosine alone.
    double density(const Place& place, float3 dir) const {
        const float total = portals_weight(&windows_, &par_, place.p, place.n), c = dot3(dir, place.n);
        if (!(total > 0 && c > 0)) return 1;
        return double(portals_density(&windows_, &par_, place.p, place.n, dir, total)) / (double(c) * K_INV_PI);
    }

    // Of the light at a place, up to the last bounce.
    double second_moment(double share) const {
        double met = 0, beyond = 0, met2 = 0, both = 0, beyond2 = 0;
        for (const Sample& sample : samples_) {
            const double over = 1 - share + share * sample.density;
            met += sample.met;
            beyond += sample.beyond;
            met2 += sample.met * sample.met / over;
            both += sample.met * sample.beyond / over;
            beyond2 += sample.beyond * sample.beyond / over;
        }

        const double n = double(samples_.size());
        double mean = 0, square = 0;
        for (int bounce = 0; bounce < par_.ab; bounce++) {
            square = (met2 + 2 * both * mean + beyond2 * square) / n;
            mean = (met + beyond * mean) / n;
        }
        return square;
    }
};

}  // namespace

float find_window_share(Device& device, const Params& par, const std::vector<float>& portals) {
    if (portals.empty() || par.ab < 1) return 0;
    return Survey(device, par, portals).share();
}

}  // namespace trace
