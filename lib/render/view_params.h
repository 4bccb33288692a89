// SPDX-License-Identifier: BSD-3-Clause
// A view in the form of kernels/geom/view_ray.h.
#pragma once
#include <cmath>
#include "base/angle.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"
#include "view/view.h"

namespace render {

inline void set_view(kernels::Params& p, const view::View& v, base::Vec3 centre) {
    const view::Projector projector(v);
    const double rad = base::degree;
    p.view_org = flatten::packed(v.vp - centre);
    p.view_d = flatten::packed(projector.forward());
    p.view_h = flatten::packed(projector.right());
    p.view_u = flatten::packed(projector.up());
    p.view_type = uint32_t(v.type);
    p.focal_distance = float(length(v.vd));
    double sx = 1, sy = 1;
    const auto stereo = [&](double t) { return 2 * std::sin(t / 2) / (1 + std::cos(t / 2)); };
    switch (v.type) {  // picture offset in [-.5,.5] times this = the projection's own coordinate
    case 'v':
        sx = 2 * std::tan(v.vh * rad / 2);
        sy = 2 * std::tan(v.vv * rad / 2);
        break;
    case 'l':
        sx = v.vh;
        sy = v.vv;
        break;
    case 'a':
        sx = v.vh / 180;
        sy = v.vv / 180;
        break;
    case 'h':
        sx = 2 * std::sin(v.vh * rad / 2);
        sy = 2 * std::sin(v.vv * rad / 2);
        break;
    case 's':
        sx = stereo(v.vh * rad);
        sy = stereo(v.vv * rad);
        break;
    case 'c':
        sx = v.vh * rad;
        sy = 2 * std::tan(v.vv * rad / 2);
        break;
    }
    p.view_scale_x = float(sx), p.view_scale_y = float(sy);
    p.view_shift = float(v.vs), p.view_lift = float(v.vl);
    p.view_fore = float(v.vo), p.view_aft = float(v.va);
    p.centre = flatten::packed(centre);
}

}  // namespace render
