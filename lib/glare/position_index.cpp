// SPDX-License-Identifier: BSD-3-Clause
// See position_index.h.
#include "glare/position_index.h"
#include <algorithm>
#include <cmath>

namespace glare {

EyeAngles eye_angles(const Geometry& g, Vec3 d, bool picture_up) {
    EyeAngles a = view::eye_angles(g.projector, d, picture_up);
    if (const EvalglareRays* rays = g.slips()) {
        const double sigma = std::acos(rays->sigma_cosine(d));
        a.sigma_deg = sigma * evalglare_deg;
        a.tau_deg = std::acos(rays->tau_cosine(d, sigma)) * evalglare_deg;
        a.elevation_deg = 90 - std::acos(std::clamp(dot(rays->sky(), d), -1.0, 1.0)) * evalglare_deg;
    }
    return a;
}

double position_index(const Geometry& g, Vec3 d, PositionModel model) {
    if (model == PositionModel::guth && g.angle_undefined(d)) return 16;
    return view::position_index(eye_angles(g, d, model == PositionModel::accelerad), g.projector, d, model);
}

}  // namespace glare
