// SPDX-License-Identifier: BSD-3-Clause
// See eye_on_surface.h.  Traces short rays through the eye, one of which crosses each surface that contains it.
#include "render/eye_on_surface.h"

#include <algorithm>
#include <cmath>

namespace render {

bool eye_on_surface(const flatten::FlatScene& flat, const flatten::HostTracer& tracer, base::Vec3 eye) {
    using base::Vec3;
    const Vec3 p = eye - flat.centre;
    const double size = flat.radius + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
    const double far = std::ldexp(size, -18);  // well above Surface.rounding
    for (int k = 0; k < 27; k++) {
        const Vec3 d{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0};
        if (length(d) == 0) continue;
        const Vec3 dir = base::unit(d);
        if (tracer.closest(eye - dir * far, dir, 0, 2 * far, flatten::HostTracer::all).t >= 0) return true;
    }
    return false;
}

}  // namespace render
