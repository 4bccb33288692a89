// SPDX-License-Identifier: BSD-3-Clause
// What the formulas need of a source, or of a bright pixel (sources.h).
#include "glare/detect.h"
#include "glare/sources.h"

namespace glare {

void place(GlareSource& s, const Geometry& g, const Settings& settings, bool inside_pixel) {
    if (inside_pixel) {
        const auto at = g.projector.direction((s.x + .5) / g.width, (s.y + .5) / g.height);
        s.direction = at ? *at : g.seen_direction(int(s.x), int(s.y));
        s.P = position_index(g.projector, s.direction, settings.position);
        s.sigma_deg = s.theta_deg = eye_angles(g.projector, s.direction).sigma_deg;
        return;
    }
    // The position index belongs to the pixel of the centre narrowed to float (90.99999999999 becomes 91);
    // evalglare takes the other directions from the pixel of the unrounded centre, we only when asked to.
    const Vec3 at = g.seen_direction(int(float(s.x)), int(float(s.y)));
    s.P = position_index(g, at, settings.position);
    s.direction = settings.slips ? g.seen_direction(int(s.x), int(s.y)) : at;
    s.sigma_deg = s.theta_deg = eye_angles(g, s.direction).sigma_deg;
}

std::vector<GlareTerm> SourceFinder::every_pixel(const Luminance& lum, const Luminance& bright_in,
                                                 double threshold) const {
    std::vector<GlareTerm> out;
    for (const Run& r : bright_runs(bright_in, geometry_, threshold))
        for (uint32_t p = r.start; p < r.start + r.length; ++p) {
            const Vec3 d = geometry_.direction(p);
            const double sigma = eye_angles(geometry_.projector, d).sigma_deg;
            const double share = lum.filled(p);
            out.push_back({lum.at(p), share * geometry_.omega[p], position_index(geometry_, d, settings_.position),
                           sigma, lum.at(p) * share * geometry_.omega_cos[p], sigma});
        }
    return out;
}

GlareTerms terms_of(const std::vector<GlareSource>& sources) {
    GlareTerms out;
    for (const GlareSource& s : sources) out.push_back({s.lum, s.omega, s.P, s.sigma_deg, s.eye_lux, s.theta_deg});
    return out;
}

GlareTerms glare_terms(const SourceFinder& finder, const Luminance& lum, const Luminance& bright_in,
                       const Settings& settings, double threshold, const std::vector<GlareSource>& sources) {
    if (settings.dgp_form == DgpForm::pixel) return finder.every_pixel(lum, bright_in, threshold);
    return terms_of(sources);
}

}  // namespace glare
