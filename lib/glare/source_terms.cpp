// SPDX-License-Identifier: BSD-3-Clause
// Formula terms of a source, or of a bright pixel (sources.h).
#include "glare/position_index.h"
#include "glare/sources.h"
#include "glare/threshold.h"

namespace glare {

GlareTerms terms_of(const std::vector<GlareSource>& sources) {
    GlareTerms out;
    for (const GlareSource& s : sources) out.push_back({s.lum, s.omega, s.P, s.sigma_deg, s.eye_lux, s.theta_deg});
    return out;
}

GlareTerms glare_terms(const Luminance& lum, const Luminance& classification_image, const Geometry& g,
                       const Settings& settings, double threshold, const std::vector<GlareSource>& sources) {
    if (settings.dgp_form == DgpForm::merged) return terms_of(sources);
    GlareTerms out;
    for (const Run& r : bright_runs(classification_image, g, threshold))
        for (uint32_t p = r.start; p < r.start + r.length; ++p) {
            const Vec3 d = g.direction(p);
            const double sigma = view::eye_angles(g.projector, d).sigma_deg;
            const double share = lum.filled(p);
            out.push_back({lum.at(p), share * g.omega[p], position_index(g, d, settings.position), sigma,
                           lum.at(p) * share * g.omega_cos[p], sigma});
        }
    return out;
}

}  // namespace glare
