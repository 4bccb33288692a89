// SPDX-License-Identifier: BSD-3-Clause
// Estimates the second moment of a path for any mixture weights from short pilot paths.  A sample of radiance f, in a
// direction of q times the cosine's pdf among those toward targets, contributes f^2 / (1 - weight + weight q) (Veach
// 1997, section 9.2).  f is the radiance that the pilot gathered plus its throughput times the mean radiance, bounce by
// bounce, as if all points were alike.
#include "sampling/mixture_weights.h"

#include "sampling/portal_lights.h"

namespace sampling {
namespace {

using namespace kernels;

constexpr double HIGHLIGHT_SHARES[] = {0, 1. / 32, 1. / 16, 1. / 8, 1. / 4, 3. / 8, 1. / 2};
constexpr double MIN_HIGHLIGHT_GAIN = 4;  // least reduction of the second moment, in squared means

using PilotList = std::vector<PilotPath>;

// Moments of the radiance at a point, up to the last bounce.  portal_pdf: of pilots by the cosine, over the cosine's;
// empty: 1.
Moments moments(const PilotList& by_cosine, const PilotList& to_highlights, const std::vector<double>& portal_pdf,
                const Params& par, double share) {
    PilotSums sums;
    for (size_t i = 0; i < by_cosine.size(); i++) {
        const double pdf = portal_pdf.empty() ? 1 : portal_pdf[i];
        sums.add(by_cosine[i], to_highlights.empty() ? 1 : by_cosine[i].weight,
                 (1 - share) * pdf + share * by_cosine[i].highlight_pdf);
    }
    for (const PilotPath& pilot : to_highlights)
        sums.add(pilot, pilot.weight, (1 - share) + share * pilot.highlight_pdf);
    return sums.all_bounces(par, double(by_cosine.size()));
}

// Mixture weight of highlights; 0 unless it clearly reduces the variance, because it costs time everywhere.
float highlight_share(const Pilots& pilots, const std::vector<double>& portal_pdf, const Params& par) {
    const auto with = [&](double share) {
        return moments(pilots.by_cosine, pilots.to_highlights, portal_pdf, par, share);
    };
    const Moments without = with(0);
    double best = 0, least = without.square;
    for (const double share : HIGHLIGHT_SHARES) {
        const double square = with(share).square;
        if (!(square < least)) continue;
        least = square;
        best = share;
    }
    return without.square - least > MIN_HIGHLIGHT_GAIN * without.mean * without.mean ? float(best) : 0;
}

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

device::Params with_mixture(device::Params par, const Mixture& m) {
    par.portals_count = uint32_t(m.portals.size());
    par.portal_rest = m.rest;
    par.portal_least = m.least;
    par.portal_most = m.most;
    par.highlight_share = m.highlight_share;
    for (size_t k = 0; k < m.portals.size(); k++) {
        par.portal_light[k] = m.portals[k].light;
        par.portal_pick[k] = m.portals[k].record;
    }
    return par;
}

Mixture weights_of(const Pilots& pilots, const Candidates& c) {
    if (pilots.by_cosine.empty()) return {};
    PortalWeights portals;
    if (c.par.portals_count > 0) portals = weigh_portals(pilots, c, moments(pilots.by_cosine, {}, {}, c.par, 0).mean);
    if (c.par.highlights_count > 0) portals.mixture.highlight_share = highlight_share(pilots, portals.pdf, c.par);
    return portals.mixture;
}

device::Params optimise_mixture(device::Device& device, const flatten::FlatScene& scene, const device::Params& par) {
    if ((scene.portals.empty() && scene.highlights.empty()) || par.ab < 1) return par;
    Candidates candidates{{}, par};
    candidates.tables.portals = scene.portals.data();
    candidates.tables.highlights = scene.highlights.data();
    pick_all_portals(par.portals_count, 1, 0, candidates.par);
    return with_mixture(par, weights_of(trace_pilots(device, candidates), candidates));
}

}  // namespace sampling
