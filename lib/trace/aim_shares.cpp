// SPDX-License-Identifier: BSD-3-Clause
// Short walks, by the cosine, tell the second moment of a path for any share.  A sample of light f, in a direction that
// has q times the cosine's density among those toward windows, counts f^2 / (1 - share + share q) (Veach 1997, section
// 9.2).  f is what the walk has met and a share of the light beyond, bounce by bounce, as if every place were like the
// mean of all.  Highlights are small: walks of their own go there, and all walks of a place are weighed by the density
// of them together.
#include "trace/aim_shares.h"

#include <algorithm>
#include <cmath>

namespace kernels {
#include "kernels/instance.h"
#include "kernels/surface.h"
#include "kernels/highlights.h"
#include "kernels/portals.h"
}  // namespace kernels

namespace trace {
namespace {

using namespace kernels;

constexpr uint32_t EYE_SIDE = 48;  // walks from the eye, a square of so many
constexpr uint32_t WALKS = 8;      // from each place that the eye sees; from those that they reach, one
constexpr int STEPS = 8;           // shares looked at: 0, 1/8 .. 7/8
constexpr double SHINES[] = {0, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 3. / 8, 1. / 2};
constexpr double WORTH_IT = 4;  // squared means: what highlights must take off the second moment

struct Place {
    float3 p, n;
};

struct Sample {
    double met = 0, beyond = 0;     // light, and the share of the light beyond
    double windows = 1, shine = 1;  // densities of directions toward windows and highlights, over the cosine's
    double weight = 1;              // 1 for a walk by the cosine, where no highlight is met
};

double luminance(const float (&c)[3]) {
    const double v = luminance3(F3(c[0], c[1], c[2]));
    return std::isfinite(v) && v > 0 ? v : 0;
}

class Survey {
public:
    Survey(Device& device, const Params& par, const std::vector<float>& records) : device_(device), par_(par) {
        par_.mode = MODE_WALK;
        par_.portals_at = 0;
        par_.portal_share = 0;
        par_.highlights_at = par.portal_count * PORTAL_FLOATS;
        tables_.f = records.data();
        const float edge =
            par.portal_count > 0 ? std::sqrt(records[PORTAL_AREA]) : length3(f3_at(&records[HIGHLIGHT_U]));
        clear_ = 1e-4f * edge;
    }

    // The largest share of windows under which the second moment is that of the cosine or less: what is met through
    // windows is smooth, and many frames have it with less noise than single samples promise.  Highlights are not
    // smooth: the share of the least (shine).
    Shares shares() {
        const std::vector<Place> near = seen(), far = look_around(near, WALKS);
        look_around(far, 1);
        Shares found;
        cosines_ = samples_.size();
        if (cosines_ == 0) return found;
        const double plain = moments(0).square;
        int step = par_.portal_count > 0 ? STEPS - 1 : 0;
        while (step > 0 && !(moments(double(step) / STEPS).square <= plain)) step--;
        found.windows = float(step) / STEPS;

        if (par_.highlight_count == 0) return found;
        send(near, WALKS, true);
        send(far, 1, true);
        found.highlights = shine(found.windows);
        return found;
    }

private:
    Device& device_;
    Params par_;
    SceneTables tables_ = {};  // of windows and highlights
    float clear_;              // rays begin so far from their surface
    std::vector<Sample> samples_;
    size_t cosines_ = 0;  // walks by the cosine

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

    // Samples by walks from each place, by the cosine; returns where they have come to.
    std::vector<Place> look_around(const std::vector<Place>& places, uint32_t walks) {
        std::vector<Place> reached;
        for (const WalkEnd& end : send(places, walks, false))
            if (end.bounce) reached.push_back(place_of(end));
        return reached;
    }

    // Adds samples: walks from each place by the cosine, or toward the highlights that it meets.
    std::vector<WalkEnd> send(const std::vector<Place>& places, uint32_t walks, bool shining) {
        std::vector<WalkRay> rays;
        const size_t first = samples_.size();
        for (uint32_t i = 0; i < places.size(); i++) {
            const Place& place = places[i];
            const uint32_t met = highlights_met(&tables_, &par_, place.p, place.n);
            for (uint32_t k = 0; k < walks && (met != 0 || !shining); k++) {
                Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, i, k, shining ? 6 : 5);
                const float2 r = sample2(&rnd);
                const float3 dir =
                    shining ? highlight_direction(&tables_, &par_, met, r.x, r.y) : cosine_direction(place.n, r.x, r.y);
                Sample sample = sample_of(place, met, dir);
                if (met != 0) sample.weight = 1 / (1 + sample.shine);  // as many go by the cosine as to highlights
                if (shining && !(dot3(dir, place.n) > 0)) sample.weight = 0;
                samples_.push_back(sample);
                const float3 org = madd3(place.n, clear_, place.p);
                rays.push_back({{org.x, org.y, org.z}, {dir.x, dir.y, dir.z}, FAR_AWAY});
            }
        }

        const std::vector<WalkEnd> ends = walk(rays);
        for (size_t k = 0; k < ends.size(); k++) {
            samples_[first + k].met = luminance(ends[k].gathered);
            samples_[first + k].beyond = ends[k].bounce ? luminance(ends[k].share) : 0;
        }
        return ends;
    }

    // Densities are 1 where nothing is to aim at: there directions go by the cosine alone.
    Sample sample_of(const Place& place, uint32_t met, float3 dir) const {
        Sample sample;
        const float c = dot3(dir, place.n);
        if (!(c > 0)) return sample;
        const double cosine = double(c) * K_INV_PI;
        const float total = portals_weight(&tables_, &par_, place.p, place.n);
        if (total > 0) sample.windows = double(portals_density(&tables_, &par_, place.p, place.n, dir, total)) / cosine;
        if (met != 0) sample.shine = double(highlights_density(&tables_, &par_, met, dir)) / cosine;
        return sample;
    }

    // Noise of highlights lies in a few bright samples, and looking for them costs time everywhere.
    float shine(double windows) const {
        const Moments without = moments(windows, 0);
        double best = 0, least = without.square;
        for (const double shine : SHINES) {
            const double square = moments(windows, shine).square;
            if (!(square < least)) continue;
            least = square;
            best = shine;
        }
        return without.square - least > WORTH_IT * without.mean * without.mean ? float(best) : 0;
    }

    struct Moments {
        double mean = 0, square = 0;
    };

    // Of the light at a place, up to the last bounce; by all walks, or by those that go by the cosine.
    Moments moments(double share, double shine) const {
        Sums sums;
        for (const Sample& sample : samples_)
            sums.add(sample, sample.weight, (1 - shine) * (1 - share + share * sample.windows) + shine * sample.shine);
        return moments(sums);
    }

    Moments moments(double share) const {
        Sums sums;
        for (const Sample& sample : samples_) sums.add(sample, 1, 1 - share + share * sample.windows);
        return moments(sums);
    }

    struct Sums {
        double met = 0, beyond = 0, met2 = 0, both = 0, beyond2 = 0;

        // over: the density of its direction over the cosine's
        void add(const Sample& sample, double weight, double over) {
            met += weight * sample.met;
            beyond += weight * sample.beyond;
            met2 += weight * sample.met * sample.met / over;
            both += weight * sample.met * sample.beyond / over;
            beyond2 += weight * sample.beyond * sample.beyond / over;
        }
    };

    Moments moments(const Sums& sums) const {
        const double n = double(cosines_);
        Moments of;
        for (int bounce = 0; bounce < par_.ab; bounce++) {
            of.square = (sums.met2 + 2 * sums.both * of.mean + sums.beyond2 * of.square) / n;
            of.mean = (sums.met + sums.beyond * of.mean) / n;
        }
        return of;
    }
};

}  // namespace

Shares find_shares(Device& device, const Params& par, const std::vector<float>& records) {
    if (records.empty() || par.ab < 1) return {};
    return Survey(device, par, records).shares();
}

}  // namespace trace
