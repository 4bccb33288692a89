// SPDX-License-Identifier: BSD-3-Clause
// In sunlight, portals are sampled in proportion to the light that they send to each point, scaled by one factor; under
// the sky alone the mixture weight is the same everywhere.  Candidates are compared by the second moment of the pilots'
// light. A glossy reflector is added if it clearly reduces the variance where its highlight is visible.
#include "sampling/portal_lights.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace kernels {
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/sampling/mixture.h"
}  // namespace kernels

namespace sampling {
namespace {

using namespace kernels;

constexpr double MIN_SELECTION_PROB = .015;  // probability below which a portal only costs time
constexpr double MIN_VARIANCE_GAIN =
    10;  // least ratio of the second moment that a glossy reflector saves to what it adds
constexpr double MIN_REFLECTOR_PROB = .0005;  // the same for a glossy reflector
constexpr size_t BRIGHTEST = 500;  // one in this number of pilots, the brightest, is excluded: too few to estimate from
constexpr double DIMMED[] = {1, .5, .25, .125};  // factors of all portals' light to try
constexpr int STEPS = 8;                         // of constant mixture weights to try: 0, 1/8 .. 7/8

// Mean of the squares without the greatest.
double trimmed_mean(std::vector<double>& squares) {
    if (squares.empty()) return 0;
    const size_t kept = squares.size() - squares.size() / BRIGHTEST;
    std::nth_element(squares.begin(), squares.begin() + long(kept) - 1, squares.end());
    double sum = 0;
    for (size_t i = 0; i < kept; i++) sum += squares[i];
    return sum / double(kept);
}

// Root mean square radiance of a portal, by the pilots toward it.
float light_of(uint32_t record, const std::vector<PilotPath>& to_portals, double mean) {
    double square = 0, view = 0;
    for (const PilotPath& pilot : to_portals) {
        if (pilot.portal != record) continue;
        square += pilot.view * pilot.light(mean) * pilot.light(mean);
        view += pilot.view;
    }
    return view > 0 ? float(std::sqrt(square / view)) : 0.0f;
}

// Light of all portals at a pilot's origin, and the pdf of its direction among those toward portals, over the cosine's.
struct Aimed {
    double total = 0, pdf = 0;
};

// A mixture, and what it means for each pilot by the cosine.
struct Tried {
    Mixture mixture;
    device::Params par;  // with it
    std::vector<Aimed> aimed;
};

// All that portals are weighed by.
struct Known {
    const std::vector<PilotPath>&pilots, &to_portals;
    const Candidates& candidates;
    const double mean;

    const Portal* portal(uint32_t record) const { return &candidates.tables.portals[record]; }
};

// With the light from other directions where portals are in view.
Tried tried(const Known& known, Mixture mixture) {
    const SceneTables& tables = known.candidates.tables;
    Tried out{std::move(mixture), {}, {}};
    out.par = with_mixture(known.candidates.par, out.mixture);
    std::vector<double> squares;
    for (const PilotPath& pilot : known.pilots) {
        Aimed aimed;
        const float total = portals_light(&tables, &out.par, pilot.p, pilot.n), c = dot3(pilot.dir, pilot.n);
        if (total > 0 && c > 0) {
            aimed.total = double(total);
            const float pdf = portals_pdf(&tables, &out.par, pilot.p, pilot.n, pilot.dir, total);
            aimed.pdf = double(pdf) / (double(c) * K_INV_PI);
            if (aimed.pdf <= 0) squares.push_back(pilot.light(known.mean) * pilot.light(known.mean));
        }
        out.aimed.push_back(aimed);
    }
    out.mixture.rest = out.par.portal_rest = K_PI * float(std::sqrt(trimmed_mean(squares)));
    return out;
}

// Mean probability of a portal.
double share_of(const Known& known, const Tried& t, const Mixture::Portal& portal) {
    double share = 0;
    for (size_t i = 0; i < known.pilots.size(); i++) {
        const float view = portal_view(known.portal(portal.record), known.pilots[i].p, known.pilots[i].n);
        const double sent = double(portal.light) * double(view);
        if (sent > 0) share += sent / (t.aimed[i].total + double(t.mixture.rest)) / double(known.pilots.size());
    }
    return share;
}

Mixture without_improbable(const Known& known, const Tried& t) {
    std::vector<double> shares;
    for (const Mixture::Portal& portal : t.mixture.portals) shares.push_back(share_of(known, t, portal));
    const double least = std::min(MIN_SELECTION_PROB, .2 * *std::max_element(shares.begin(), shares.end()));
    Mixture out = t.mixture;
    out.portals.clear();
    for (size_t k = 0; k < shares.size(); k++)
        if (!(shares[k] < least)) out.portals.push_back(t.mixture.portals[k]);
    return out;
}

// Over the points with pilots to a reflector: returns true if the second moment of the reflector's light falls by more
// than that of all other light rises, which is sampled less often.  Pilots by the cosine rarely hit a highlight.
bool reduces_variance(const Known& known, const Tried& t, const device::Params& par, const Mixture::Portal& reflector) {
    const SceneTables& tables = known.candidates.tables;
    double saved = 0, lost = 0;
    for (const PilotPath& pilot : known.to_portals) {
        if (pilot.portal != reflector.record) continue;
        const float view = portal_view(known.portal(reflector.record), pilot.p, pilot.n),
                    aimed = portal_pdf(known.portal(reflector.record), pilot.p, pilot.dir);
        if (!(view > 0 && aimed > 0)) continue;
        const float total = portals_light(&tables, &par, pilot.p, pilot.n);
        const double others = double(total), sent = double(reflector.light) * double(view);
        const double before = double(portals_weight(&par, total));
        const double now = double(portals_weight(&par, float(others + sent))),
                     reflectors = now * sent / (others + sent);

        const double cosine = double(dot3(pilot.dir, pilot.n)) * K_INV_PI, f = pilot.light(known.mean) * cosine;
        const double by_cosine = (1 - before) * cosine, mixed = (1 - now) * cosine + reflectors * double(aimed);
        saved += (f * f / by_cosine - f * f / mixed) / double(aimed);
        const double rest = double(par.portal_rest) * K_INV_PI, through = others * K_INV_PI;
        lost += rest * rest * (1 / (1 - now) - 1 / (1 - before));
        if (before > 0) lost += through * through * (1 / (now - reflectors) - 1 / before);
    }
    return saved > MIN_VARIANCE_GAIN * lost && share_of(known, t, reflector) >= MIN_REFLECTOR_PROB;
}

Tried with_reflectors(const Known& known, const Tried& t, const std::vector<Mixture::Portal>& reflectors) {
    Mixture mixture = t.mixture;
    for (const Mixture::Portal& reflector : reflectors)
        if (reduces_variance(known, t, with_mixture(t.par, mixture), reflector)) mixture.portals.push_back(reflector);
    Tried out = tried(known, mixture);
    out.mixture.rest = out.par.portal_rest = t.mixture.rest;
    return out;
}

// Pdf of a pilot's direction over the cosine's, with `dimmed` times the portals' light.
double mixed(const Tried& t, size_t i, double dimmed) {
    const double share = double(portals_weight(&t.par, float(dimmed * t.aimed[i].total)));
    return 1 - share + share * t.aimed[i].pdf;
}

double moment(const Known& known, const Tried& t, double dimmed) {
    PilotSums all;
    for (size_t i = 0; i < known.pilots.size(); i++) all.add(known.pilots[i], 1, mixed(t, i, dimmed));
    return all.all_bounces(t.par, double(known.pilots.size())).square;
}

// The same without the brightest pilots, which are too few to compare by.
double moment_of_most(const Known& known, const Tried& t, double dimmed) {
    std::vector<double> squares, order;
    for (size_t i = 0; i < known.pilots.size(); i++) {
        const double light = known.pilots[i].light(known.mean);
        squares.push_back(light * light / mixed(t, i, dimmed));
    }
    order = squares;
    const auto brightest = order.end() - long(order.size() / BRIGHTEST) - 1;
    std::nth_element(order.begin(), brightest, order.end());
    PilotSums most;
    for (size_t i = 0; i < known.pilots.size(); i++)
        if (squares[i] <= *brightest) most.add(known.pilots[i], 1, mixed(t, i, dimmed));
    return most.all_bounces(t.par, double(known.pilots.size())).square;
}

// Sunlight: portals in proportion to their light.  Among the factors whose second moment is at most the cosine's, with
// all pilots, chooses the one with the least second moment without the brightest.
Tried dimmed(const Known& known, Tried t) {
    const double plain = moment(known, t, 0);
    double best = 0, least = moment_of_most(known, t, 0);
    for (const double factor : DIMMED) {
        const double found = moment_of_most(known, t, factor);
        if (!(found < least && moment(known, t, factor) <= plain)) continue;
        least = found;
        best = factor;
    }
    for (Mixture::Portal& portal : t.mixture.portals) portal.light *= float(best);
    for (Aimed& aimed : t.aimed) aimed.total *= best;
    if (best <= 0) t.mixture.portals.clear();
    t.par = with_mixture(t.par, t.mixture);
    return t;
}

// Sky alone: the largest constant mixture weight whose second moment is at most the cosine's.  Light through windows is
// smooth, so the sequence of samples estimates it with less variance than independent samples suggest.
Tried with_constant_share(const Known& known, Tried t) {
    const double plain = moment(known, t, 0);
    int step = STEPS;
    do {
        step--;
        t.mixture.least = t.mixture.most = float(step) / STEPS;
        t.par = with_mixture(t.par, t.mixture);
    } while (step > 0 && !(moment(known, t, 1) <= plain));
    if (step == 0) t.mixture.portals.clear();
    return t;
}

}  // namespace

PortalWeights weigh_portals(const Pilots& pilots, const Candidates& candidates, double mean) {
    const Known known{pilots.by_cosine, pilots.to_portals, candidates, mean};
    Mixture lights;
    std::vector<Mixture::Portal> reflectors;
    for (uint32_t k = 0; k < candidates.par.portals_count; k++)
        (known.portal(k)->gloss2 > 0 ? reflectors : lights.portals)
            .push_back({k, light_of(k, pilots.to_portals, mean)});
    const bool sun_comes_in = lights.portals.size() > candidates.par.window_count;
    Tried t = tried(known, lights);
    if (sun_comes_in) {
        t = dimmed(known, tried(known, without_improbable(known, t)));
        t = with_reflectors(known, t, reflectors);
    } else {
        t = with_constant_share(known, std::move(t));
    }
    PortalWeights out{t.mixture, {}};
    for (size_t i = 0; i < known.pilots.size(); i++) out.pdf.push_back(mixed(t, i, 1));
    return out;
}

}  // namespace sampling
