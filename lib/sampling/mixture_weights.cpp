// SPDX-License-Identifier: BSD-3-Clause
// Estimates the second moment of a path for any mixture weights from short pilot paths.  A sample of radiance f, in a
// direction of q times the cosine's pdf among those toward targets, contributes f^2 / (1 - weight + weight q) (Veach
// 1997, section 9.2).  f is the radiance that the pilot gathered plus its throughput times the mean radiance, bounce by
// bounce, as if all points were alike.  Portals and highlights are small, so other pilots are sent toward them; those
// to highlights and those by the cosine are weighted by the pdf of both.
#include "sampling/mixture_weights.h"

#include <algorithm>
#include <cmath>

#include "sampling/portal_lights.h"

namespace kernels {
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/sampling/mixture.h"
}  // namespace kernels

namespace sampling {
namespace {

using namespace kernels;

constexpr uint32_t LEAST_SIDE = 16, MOST_SIDE = 32;  // of the square of pilots from the eye
// Pixels of the picture's side for one of them: in a small picture learning would take as long as four frames.
constexpr double PIXELS = 4;
constexpr uint32_t PILOTS = 8;      // from each point that the eye sees; one from each point that these reach
constexpr float MOST_AIMED = 0.5f;  // of the directions, so that unknown light is sampled, too
constexpr size_t AIMED = 256;       // pilots to each portal
constexpr double HIGHLIGHT_SHARES[] = {0, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 3. / 8, 1. / 2};
constexpr double MIN_HIGHLIGHT_GAIN = 4;  // least reduction of the second moment, in squared means

struct Place {
    float3 p, n;
};

class PilotSampler {
public:
    PilotSampler(device::Device& device, const device::Params& par, const flatten::FlatScene& scene)
        : device_(device), par_(par) {
        par_.mode = MODE_PILOT;
        pick_all_portals(par.portals_count, 1, 0, par_);
        tables_.portals = scene.portals.data();
        tables_.highlights = scene.highlights.data();
        const float edge =
            par.portals_count > 0 ? std::sqrt(scene.portals[0].area) : length3(f3_of(scene.highlights[0].u));
        clear_ = 1e-4f * edge;
    }

    void find(Params& par) {
        const std::vector<Place> near = seen();
        std::vector<Place> far = look_around(near, PILOTS), all = near;
        look_around(far, 1);
        cosines_ = pilots_.size();
        par.portals_count = 0;
        if (cosines_ == 0) return;
        if (par_.portals_count > 0) {
            all.insert(all.end(), far.begin(), far.end());
            choose_portals(all, par);
        }
        if (par_.highlights_count == 0) return;
        send(near, PILOTS, true);
        send(far, 1, true);
        par.highlight_share = highlight_share();
    }

private:
    device::Device& device_;
    device::Params par_;
    SceneTables tables_ = {};  // of portals and highlights
    float clear_;              // offset of rays from their surface
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
        const double pixels = std::sqrt(double(par_.nx) * par_.ny);
        const uint32_t side = std::clamp(uint32_t(pixels / PIXELS), LEAST_SIDE, MOST_SIDE);
        for (uint32_t i = 0; i < side * side; i++) {
            const float x = float(i % side) + 0.5f, y = float(i / side) + 0.5f;
            rays.push_back({{x / float(side), y / float(side), 0}, {0, 0, 0}, PILOT_FROM_EYE});
        }
        std::vector<Place> places;
        for (const device::PilotEnd& end : trace(rays))
            if (end.bounce) places.push_back(place_of(end));
        return places;
    }

    // Pilot paths from each point, by the cosine; returns the points that they reach.
    std::vector<Place> look_around(const std::vector<Place>& places, uint32_t pilots) {
        std::vector<Place> reached;
        for (const device::PilotEnd& end : send(places, pilots, false))
            if (end.bounce) reached.push_back(place_of(end));
        return reached;
    }

    // Adds pilots from each point, by the cosine or toward the highlights that can be sampled from it.
    std::vector<device::PilotEnd> send(const std::vector<Place>& places, uint32_t pilots, bool to_highlights) {
        std::vector<device::PilotRay> rays;
        const size_t first = pilots_.size();
        for (uint32_t i = 0; i < places.size(); i++) {
            const Place& place = places[i];
            const uint32_t met = highlights_met(&tables_, &par_, place.p, place.n);
            for (uint32_t k = 0; k < pilots && (met != 0 || !to_highlights); k++) {
                Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, i, k, to_highlights ? 6 : 5);
                const float2 r = sample2(&rnd);
                const float3 dir =
                    to_highlights ? highlights_sample(&tables_, met, r.x, r.y) : cosine_sample(place.n, r.x, r.y);
                pilots_.push_back(pilot_of(place, met, dir));
                if (to_highlights && !(dot3(dir, place.n) > 0)) pilots_.back().weight = 0;
                rays.push_back(ray_of(place, dir));
            }
        }

        const std::vector<device::PilotEnd> ends = trace(rays);
        for (size_t k = 0; k < ends.size(); k++) pilots_[first + k].set_end(ends[k]);
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
        if (met != 0 && cosine > 0) pilot.highlight_pdf = double(highlights_pdf(&tables_, met, dir)) / cosine;
        if (met != 0) pilot.weight = 1 / (1 + pilot.highlight_pdf);  // equal numbers go by the cosine and to highlights
        return pilot;
    }

    void choose_portals(const std::vector<Place>& places, Params& par) {
        const double mean = moments(0).mean;
        for (uint32_t k = 0; k < par_.portals_count; k++) par_.portal_light[k] = light_of(k, places, mean);
        weigh_portals(tables_, pilots_, to_reflectors_, mean, par_);
        par.portals_count = par_.portals_count;
        par.portal_rest = par_.portal_rest;
        par.portal_least = par_.portal_least;
        par.portal_most = par_.portal_most;
        std::copy(par_.portal_light, par_.portal_light + par_.portals_count, par.portal_light);
        std::copy(par_.portal_pick, par_.portal_pick + par_.portals_count, par.portal_pick);
    }

    // Radiance of a portal, by pilots from all points toward random points of it.
    float light_of(uint32_t k, const std::vector<Place>& places, double mean) {
        const Portal* portal = portal_record(&tables_, &par_, k);
        std::vector<device::PilotRay> rays;
        std::vector<double> views;
        std::vector<PilotPath> pilots;
        for (size_t i = 0; i < AIMED; i++) {
            const Place& place = places[i * places.size() / AIMED];
            const float view = portal_view(portal, place.p, place.n);
            Sampler rnd = sampler_start(par_.seed_lo, par_.seed_hi, uint32_t(i), k, 7);
            const float2 r = sample2(&rnd);
            const float3 along = madd3(f3_of(portal->u), r.x - 0.5f, f3_of(portal->centre));
            const float3 dir = unit3(sub3(madd3(f3_of(portal->v), r.y - 0.5f, along), place.p));
            if (!(view > 0 && dot3(dir, place.n) > 0)) continue;
            rays.push_back(ray_of(place, dir));
            views.push_back(double(view));
            pilots.push_back(pilot_of(place, 0, dir));
        }
        AimedLight light;
        const std::vector<device::PilotEnd> ends = trace(rays);
        for (size_t i = 0; i < ends.size(); i++) {
            pilots[i].set_end(ends[i]);
            light.add(pilots[i].gathered + pilots[i].throughput * mean, views[i]);
            pilots[i].target = k;
        }
        if (portal->gloss2 > 0) to_reflectors_.insert(to_reflectors_.end(), pilots.begin(), pilots.end());
        return light.root();
    }

    // Mixture weight of highlights; 0 unless it clearly reduces the variance, because it costs time everywhere.
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

    // Moments of the radiance at a point, up to the last bounce.  All pilots have one weight while all are by the
    // cosine.
    Moments moments(double share) const {
        PilotSums sums;
        for (const PilotPath& pilot : pilots_)
            sums.add(pilot, pilots_.size() == cosines_ ? 1 : pilot.weight,
                     (1 - share) * pilot.portal_pdf + share * pilot.highlight_pdf);
        return sums.all_bounces(par_, double(cosines_));
    }
};

}  // namespace

void pick_all_portals(uint32_t count, float light, float rest, Params& par) {
    par.portals_count = count;
    par.portal_rest = rest;
    par.portal_least = 0;
    par.portal_most = MOST_AIMED;
    for (uint32_t k = 0; k < MOST_PORTALS; k++) {
        par.portal_light[k] = light;
        par.portal_pick[k] = k;
    }
}

device::Params optimise_mixture(device::Device& device, const flatten::FlatScene& scene, device::Params par) {
    const bool any = !scene.portals.empty() || !scene.highlights.empty();
    if (any && par.ab >= 1) PilotSampler(device, par, scene).find(par);
    return par;
}

}  // namespace sampling
