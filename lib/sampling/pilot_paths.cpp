// SPDX-License-Identifier: BSD-3-Clause
// See pilot_paths.h.  Portals and highlights are small, so some pilots are sent toward them; those to highlights and
// those by the cosine are weighted by the pdf of both.
#include "sampling/pilot_paths.h"

#include <cmath>

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
constexpr uint32_t PILOTS = 8;  // from each point that the eye sees; one from each point that these reach
constexpr size_t AIMED = 256;   // pilots to each portal

struct Place {
    float3 p, n;
};

// What a pass of the device needs; its frame counts, so that each pass has other random numbers.
struct Tracer {
    device::Device& device;
    const Candidates& candidates;
    device::Params par;
    float clear;  // offset of rays from their surface
};

std::vector<device::PilotEnd> trace(Tracer& t, const std::vector<device::PilotRay>& rays) {
    std::vector<device::PilotEnd> ends;
    t.par.first = 0;
    t.par.path_count = uint32_t(rays.size());
    if (!rays.empty()) t.device.pilot(t.par, rays, ends);
    t.par.frame++;
    return ends;
}

std::vector<Place> bounces_of(const std::vector<device::PilotEnd>& ends) {
    std::vector<Place> places;
    for (const device::PilotEnd& end : ends)
        if (end.bounce) places.push_back({F3(end.p[0], end.p[1], end.p[2]), F3(end.n[0], end.n[1], end.n[2])});
    return places;
}

std::vector<Place> seen(Tracer& t) {
    std::vector<device::PilotRay> rays;
    const double pixels = std::sqrt(double(t.par.nx) * t.par.ny);
    const uint32_t side = std::clamp(uint32_t(pixels / PIXELS), LEAST_SIDE, MOST_SIDE);
    for (uint32_t i = 0; i < side * side; i++) {
        const float x = float(i % side) + 0.5f, y = float(i / side) + 0.5f;
        rays.push_back({{x / float(side), y / float(side), 0}, {0, 0, 0}, PILOT_FROM_EYE});
    }
    return bounces_of(trace(t, rays));
}

device::PilotRay ray_of(const Tracer& t, const PilotPath& pilot) {
    const float3 org = madd3(pilot.n, t.clear, pilot.p);
    return {{org.x, org.y, org.z}, {pilot.dir.x, pilot.dir.y, pilot.dir.z}, FAR_AWAY};
}

void set_end(const device::PilotEnd& end, PilotPath& pilot) {
    const auto luminance = [](const float(&c)[3]) {
        const double v = luminance3(F3(c[0], c[1], c[2]));
        return std::isfinite(v) && v > 0 ? v : 0;
    };
    pilot.gathered = luminance(end.gathered);
    pilot.throughput = end.bounce ? luminance(end.throughput) : 0;
}

// Follows the pilots; returns the points that they reach.
std::vector<Place> follow(Tracer& t, std::vector<PilotPath> pilots, std::vector<PilotPath>& all) {
    std::vector<device::PilotRay> rays;
    for (const PilotPath& pilot : pilots) rays.push_back(ray_of(t, pilot));
    const std::vector<device::PilotEnd> ends = trace(t, rays);
    for (size_t k = 0; k < ends.size(); k++) set_end(ends[k], pilots[k]);
    all.insert(all.end(), pilots.begin(), pilots.end());
    return bounces_of(ends);
}

// Pilots from each point, by the cosine or toward the highlights that can be sampled from it.
std::vector<PilotPath> look_around(const Candidates& c, const std::vector<Place>& places, uint32_t pilots,
                                   bool to_highlights) {
    std::vector<PilotPath> out;
    for (uint32_t i = 0; i < places.size(); i++) {
        const Place& place = places[i];
        const uint32_t met = highlights_met(&c.tables, &c.par, place.p, place.n);
        for (uint32_t k = 0; k < pilots && (met != 0 || !to_highlights); k++) {
            Sampler rnd = sampler_start(c.par.seed_lo, c.par.seed_hi, i, k, to_highlights ? 6 : 5);
            const float2 r = sample2(&rnd);
            PilotPath pilot;
            pilot.p = place.p, pilot.n = place.n;
            pilot.dir = to_highlights ? highlights_sample(&c.tables, met, r.x, r.y) : cosine_sample(place.n, r.x, r.y);
            const double cosine = double(dot3(pilot.dir, place.n)) * K_INV_PI;
            if (met != 0 && cosine > 0)
                pilot.highlight_pdf = double(highlights_pdf(&c.tables, met, pilot.dir)) / cosine;
            // Equal numbers go by the cosine and to highlights.
            if (met != 0) pilot.weight = 1 / (1 + pilot.highlight_pdf);
            if (to_highlights && !(dot3(pilot.dir, place.n) > 0)) pilot.weight = 0;
            out.push_back(pilot);
        }
    }
    return out;
}

// Pilots from all points toward random points of portal k.
std::vector<PilotPath> to_portal(const Candidates& c, uint32_t k, const std::vector<Place>& places) {
    const Portal* portal = portal_record(&c.tables, &c.par, k);
    std::vector<PilotPath> out;
    for (size_t i = 0; i < AIMED; i++) {
        const Place& place = places[i * places.size() / AIMED];
        PilotPath pilot;
        pilot.p = place.p, pilot.n = place.n, pilot.portal = k;
        pilot.view = double(portal_view(portal, place.p, place.n));
        Sampler rnd = sampler_start(c.par.seed_lo, c.par.seed_hi, uint32_t(i), k, 7);
        const float2 r = sample2(&rnd);
        const float3 along = madd3(f3_of(portal->u), r.x - 0.5f, f3_of(portal->centre));
        pilot.dir = unit3(sub3(madd3(f3_of(portal->v), r.y - 0.5f, along), place.p));
        if (pilot.view > 0 && dot3(pilot.dir, place.n) > 0) out.push_back(pilot);
    }
    return out;
}

}  // namespace

Pilots trace_pilots(device::Device& device, const Candidates& c) {
    const float edge =
        c.par.portals_count > 0 ? std::sqrt(c.tables.portals[0].area) : length3(f3_of(c.tables.highlights[0].u));
    Tracer t{device, c, c.par, 1e-4f * edge};
    t.par.mode = MODE_PILOT;
    Pilots out;
    const std::vector<Place> near = seen(t);
    const std::vector<Place> far = follow(t, look_around(c, near, PILOTS, false), out.by_cosine);
    follow(t, look_around(c, far, 1, false), out.by_cosine);
    if (out.by_cosine.empty()) return out;
    std::vector<Place> all = near;
    all.insert(all.end(), far.begin(), far.end());
    for (uint32_t k = 0; k < c.par.portals_count; k++) follow(t, to_portal(c, k, all), out.to_portals);
    if (c.par.highlights_count == 0) return out;
    follow(t, look_around(c, near, PILOTS, true), out.to_highlights);
    follow(t, look_around(c, far, 1, true), out.to_highlights);
    return out;
}

}  // namespace sampling
