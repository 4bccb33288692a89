// SPDX-License-Identifier: BSD-3-Clause
// Short pilots tell the second moment of a path for any share.  A sample of light f, in a direction that has q times
// the cosine's pdf among those aimed at, counts f^2 / (1 - share + share q) (Veach 1997, section 9.2).  f is what the
// pilot has met and a share of the light beyond, bounce by bounce, as if every place were like the mean of all.
// Portals and highlights are small: pilots of their own go there.  Those to highlights and those by the cosine are
// weighed together by the pdf of both.
#include "sampling/mixture_weights.h"

#include <algorithm>
#include <cmath>

#include "sampling/portal_lights.h"

namespace kernels {
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/sampling/highlights.h"
#include "kernels/sampling/portals.h"
}  // namespace kernels

namespace sampling {
namespace {

using namespace kernels;

constexpr uint32_t EYE_SIDE = 48;   // pilots from the eye, a square of so many
constexpr uint32_t PILOTS = 8;      // from each place that the eye sees; from those that they reach, one
constexpr float MOST_AIMED = 0.5f;  // of the directions, so that what is not known is found too
constexpr size_t AIMED = 1024;      // to each portal
constexpr double HIGHLIGHT_SHARES[] = {0, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 3. / 8, 1. / 2};
constexpr double MIN_HIGHLIGHT_GAIN = 4;  // squared means: what highlights must take off the second moment

struct Place {
    float3 p, n;
};

double luminance(const float (&c)[3]) {
    const double v = luminance3(F3(c[0], c[1], c[2]));
    return std::isfinite(v) && v > 0 ? v : 0;
}

class PilotSampler {
public:
    PilotSampler(device::Device& device, const Params& par, const std::vector<float>& records)
        : device_(device), par_(par), records_(records) {
        par_.mode = MODE_PILOT;
        par_.portals_at = 0;
        pick_all_portals(par.portal_count, 1, 0, par_);
        par_.highlights_at = par.portal_count * PORTAL_FLOATS;
        tables_.f = records.data();
        const float edge =
            par.portal_count > 0 ? std::sqrt(records[PORTAL_AREA]) : length3(f3_at(&records[HIGHLIGHT_U]));
        clear_ = 1e-4f * edge;
    }

    void find(Params& par) {
        const std::vector<Place> near = seen();
        std::vector<Place> far = look_around(near, PILOTS), all = near;
        look_around(far, 1);
        cosines_ = pilots_.size();
        par.portal_count = 0;
        if (cosines_ == 0) return;
        if (par_.portal_count > 0) {
            all.insert(all.end(), far.begin(), far.end());
            choose_portals(all, par);
        }
        if (par_.highlight_count == 0) return;
        send(near, PILOTS, true);
        send(far, 1, true);
        par.highlight_share = highlight_share();
    }

private:
    device::Device& device_;
    Params par_;
    const std::vector<float>& records_;
    SceneTables tables_ = {};  // of portals and highlights
    float clear_;              // rays begin so far from their surface
    std::vector<PilotPath> pilots_;
    size_t cosines_ = 0;                    // pilots by the cosine
    std::vector<PilotPath> to_reflectors_;  // toward glossy reflectors

    std::vector<device::PilotEnd> trace(const std::vector<device::PilotRay>& rays) {
        std::vector<device::PilotEnd> ends;
        par_.first = 0;
        par_.path_count = uint32_t(rays.size());
        if (!rays.empty()) device_.pilot(par_, rays, ends);
        par_.frame++;  // other random numbers for the next
        return ends;
    }

    static Place place_of(const device::PilotEnd& end) {
        return {F3(end.p[0], end.p[1], end.p[2]), F3(end.n[0], end.n[1], end.n[2])};
    }

    std::vector<Place> seen() {
        std::vector<device::PilotRay> rays;
        for (uint32_t i = 0; i < EYE_SIDE * EYE_SIDE; i++) {
            const float x = float(i % EYE_SIDE) + 0.5f, y = float(i / EYE_SIDE) + 0.5f;
            rays.push_back({{x / EYE_SIDE, y / EYE_SIDE, 0}, {0, 0, 0}, PILOT_FROM_EYE});
        }
        std::vector<Place> places;
        for (const device::PilotEnd& end : trace(rays))
            if (end.bounce) places.push_back(place_of(end));
        return places;
    }

    // Pilot paths from each place, by the cosine; returns where they have come to.
    std::vector<Place> look_around(const std::vector<Place>& places, uint32_t pilots) {
        std::vector<Place> reached;
        for (const device::PilotEnd& end : send(places, pilots, false))
            if (end.bounce) reached.push_back(place_of(end));
        return reached;
    }

    // Adds pilots from each place by the cosine, or toward the highlights that it meets.
    std::vector<device::PilotEnd> send(const std::vector<Place>& places, uint32_t pilots, bool shining) {
        std::vector<device::PilotRay> rays;
        const size_t first = pilots_.size();
        for (uint32_t i = 0; i < places.size(); i++) {
            const Place& place = places[i];
            const uint32_t met = highlights_met(&tables_, &par_, place.p, place.n);
            for (uint32_t k = 0; k < pilots && (met != 0 || !shining); k++) {
                Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, i, k, shining ? 6 : 5);
                const float2 r = sample2(&rnd);
                const float3 dir =
                    shining ? highlight_direction(&tables_, &par_, met, r.x, r.y) : cosine_direction(place.n, r.x, r.y);
                pilots_.push_back(pilot_of(place, met, dir));
                if (shining && !(dot3(dir, place.n) > 0)) pilots_.back().weight = 0;
                rays.push_back(ray_of(place, dir));
            }
        }

        const std::vector<device::PilotEnd> ends = trace(rays);
        for (size_t k = 0; k < ends.size(); k++) {
            pilots_[first + k].met = luminance(ends[k].gathered);
            pilots_[first + k].beyond = ends[k].bounce ? luminance(ends[k].share) : 0;
        }
        return ends;
    }

    device::PilotRay ray_of(const Place& place, float3 dir) const {
        const float3 org = madd3(place.n, clear_, place.p);
        return {{org.x, org.y, org.z}, {dir.x, dir.y, dir.z}, FAR_AWAY};
    }

    PilotPath pilot_of(const Place& place, uint32_t met, float3 dir) const {
        PilotPath pilot;
        pilot.p = place.p;
        pilot.n = place.n;
        pilot.dir = dir;
        const double cosine = double(dot3(dir, place.n)) * K_INV_PI;
        if (met != 0 && cosine > 0) pilot.shine = double(highlights_pdf(&tables_, &par_, met, dir)) / cosine;
        if (met != 0) pilot.weight = 1 / (1 + pilot.shine);  // as many go by the cosine as to highlights
        return pilot;
    }

    void choose_portals(const std::vector<Place>& places, Params& par) {
        const double mean = moments(0).mean;
        for (uint32_t k = 0; k < par_.portal_count; k++) par_.portal_light[k] = light_of(k, places, mean);
        weigh_portals(records_, pilots_, to_reflectors_, mean, par_);
        par.portal_count = par_.portal_count;
        par.portal_rest = par_.portal_rest;
        par.portal_least = par_.portal_least;
        par.portal_most = par_.portal_most;
        std::copy(par_.portal_light, par_.portal_light + par_.portal_count, par.portal_light);
        std::copy(par_.portal_pick, par_.portal_pick + par_.portal_count, par.portal_pick);
    }

    // The light of a portal, by pilots from places all over toward points all over it.
    float light_of(uint32_t k, const std::vector<Place>& places, double mean) {
        const float* portal = portal_record(&tables_, &par_, k);
        std::vector<device::PilotRay> rays;
        std::vector<double> views;
        std::vector<PilotPath> pilots;
        for (size_t i = 0; i < AIMED; i++) {
            const Place& place = places[i * places.size() / AIMED];
            const float view = portal_view(portal, place.p, place.n);
            Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, uint32_t(i), k, 7);
            const float2 r = sample2(&rnd);
            const float3 along = madd3(f3_at(portal + PORTAL_U), r.x - 0.5f, f3_at(portal + PORTAL_CENTRE));
            const float3 dir = unit3(sub3(madd3(f3_at(portal + PORTAL_V), r.y - 0.5f, along), place.p));
            if (!(view > 0 && dot3(dir, place.n) > 0)) continue;
            rays.push_back(ray_of(place, dir));
            views.push_back(double(view));
            pilots.push_back(pilot_of(place, 0, dir));
        }
        AimedLight light;
        const std::vector<device::PilotEnd> ends = trace(rays);
        for (size_t i = 0; i < ends.size(); i++) {
            const double beyond = ends[i].bounce ? luminance(ends[i].share) : 0;
            light.add(luminance(ends[i].gathered) + beyond * mean, views[i]);
            pilots[i].met = luminance(ends[i].gathered);
            pilots[i].beyond = ends[i].bounce ? luminance(ends[i].share) : 0;
            pilots[i].target = k;
        }
        if (portal[PORTAL_GLOSS2] > 0) to_reflectors_.insert(to_reflectors_.end(), pilots.begin(), pilots.end());
        return light.root();
    }

    // Noise of highlights lies in a few bright samples, and looking for them costs time everywhere.
    float highlight_share() const {
        const Moments without = moments(0);
        double best = 0, least = without.square;
        for (const double share : HIGHLIGHT_SHARES) {
            const double square = moments(share).square;
            if (!(square < least)) continue;
            least = square;
            best = share;
        }
        return without.square - least > MIN_HIGHLIGHT_GAIN * without.mean * without.mean ? float(best) : 0;
    }

    struct Moments {
        double mean = 0, square = 0;
    };

    // Of the light at a place, up to the last bounce.  As long as all pilots went by the cosine each counts the same.
    Moments moments(double shine) const {
        Sums sums;
        for (const PilotPath& pilot : pilots_)
            sums.add(pilot, pilots_.size() == cosines_ ? 1 : pilot.weight,
                     (1 - shine) * pilot.portals + shine * pilot.shine);
        return moments(sums);
    }

    struct Sums {
        double met = 0, beyond = 0, met2 = 0, both = 0, beyond2 = 0;

        // over: the pdf of its direction over the cosine's
        void add(const PilotPath& pilot, double weight, double over) {
            met += weight * pilot.met;
            beyond += weight * pilot.beyond;
            met2 += weight * pilot.met * pilot.met / over;
            both += weight * pilot.met * pilot.beyond / over;
            beyond2 += weight * pilot.beyond * pilot.beyond / over;
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

void pick_all_portals(uint32_t count, float light, float rest, Params& par) {
    par.portal_count = count;
    par.portal_rest = rest;
    par.portal_least = 0;
    par.portal_most = MOST_AIMED;
    for (uint32_t k = 0; k < MOST_PORTALS; k++) {
        par.portal_light[k] = light;
        par.portal_pick[k] = k;
    }
}

void optimise_mixture(device::Device& device, const std::vector<float>& records, Params& par) {
    if (records.empty() || par.ab < 1) return;
    PilotSampler(device, par, records).find(par);
}

}  // namespace sampling
