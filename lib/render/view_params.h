// SPDX-License-Identifier: BSD-3-Clause
// A view in the form of kernels/geom/view_ray.h.
#pragma once
#include <cmath>
#include "base/angle.h"
#include "kernels/dialect/host.h"
#include "view/view.h"

namespace render {

inline void set_view(kernels::Params& p, const view::View& v, base::Vec3 centre) {
    const view::Projector projector(v);
    const double rad = base::degree;
    const auto put = [](kernels::float4& f, base::Vec3 a, double w) {
        f = {float(a.x), float(a.y), float(a.z), float(w)};
    };
    put(p.view_org, v.vp - centre, 0);
    put(p.view_d, projector.forward(), double(v.type));
    put(p.view_h, projector.right(), length(v.vd));  // w: focal distance
    put(p.view_u, projector.up(), 0);
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
    p.view_size = {float(sx), float(sy), float(v.vs), float(v.vl)};
    p.view_clip = {float(v.vo), float(v.va), p.view_clip.z, p.view_clip.w};
    put(p.centre, centre, 0);
}

}  // namespace render
