// SPDX-License-Identifier: BSD-3-Clause
// See odd_eye.h.
#include "render/odd_eye.h"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "flatten/host_tracer.h"

namespace render {

using base::Vec3;

namespace {

constexpr double odd = 300;  // times larger than it can be meant; between metres and millimetres are 1,000

bool is_under_all(const flatten::HostTracer& tracer, Vec3 eye) {
    for (const double z : {-1., 0., 1.})
        for (const double x : {-1., 0., 1.})
            for (const double y : {-1., 0., 1.}) {
                const Vec3 dir{x, y, z};
                if (x == 0 && y == 0 && z == 0) continue;
                const bool met = tracer.closest(eye, base::unit(dir), 0, 1e30, flatten::HostTracer::all).t >= 0;
                if (met != (z > 0)) return false;
            }
    return true;
}

}  // namespace

std::string odd_about_eye(const flatten::FlatScene& tables, Vec3 eye) {
    const flatten::HostTracer tracer(tables);
    double width[3];
    bool inside = true, in_corner = true;
    for (int k = 0; k < 3; k++) {
        Vec3 dir;
        dir[k] = 1;
        const double ahead = tracer.closest(eye, dir, 0, 1e30, flatten::HostTracer::all).t,
                     behind = tracer.closest(eye, dir * -1, 0, 1e30, flatten::HostTracer::all).t;
        inside = inside && ahead >= 0 && behind >= 0;
        width[k] = ahead + behind;
        in_corner = in_corner && std::min(ahead, behind) * odd < width[k];
    }
    const std::string size = fmt::format("{:.4g} x {:.4g} x {:.4g}", width[0], width[1], width[2]);
    if (inside && in_corner)
        return "the eye is in the outermost corner of a room of " + size + ": is the model in millimetres?";
    if (inside && *std::max_element(width, width + 3) * odd < tables.radius)
        return "surfaces on all sides leave the eye " + size + ": is it inside a solid?";
    const double away = base::length(eye - flatten::centre_of(tables.boxes, nullptr));
    if (tables.radius > 0 && away > odd * tables.radius)
        return fmt::format("the eye is {:.3g} away from a scene of {:.3g}: are they in the same units?", away,
                           2 * tables.radius);
    if (is_under_all(tracer, eye)) return "all surfaces are above the eye: is it under the ground?";
    return "";
}

}  // namespace render
