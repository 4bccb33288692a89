// SPDX-License-Identifier: BSD-3-Clause
// Kernel parameters of a scene and its options (view_params.h has the view's).
#pragma once
#include <algorithm>
#include "flatten/flat_scene.h"
#include "kernels/dialect/host.h"
#include "render/options.h"

namespace render {

// Parameters that do not depend on the view.
#define SET_TABLE_COUNT(type, name) p.name##_count = uint32_t(flat.name.size());
inline kernels::Params params_of(const flatten::FlatScene& flat, const RenderOptions& o) {
    kernels::Params p{};
    p.pixel_jitter = float(o.pj);
    p.lens_diameter = float(o.pd);
    p.av = {float(o.av[0]), float(o.av[1]), float(o.av[2])};
    p.seed_lo = uint32_t(o.seed);
    p.seed_hi = uint32_t(o.seed >> 32);
    RECORD_TABLES(SET_TABLE_COUNT)
    p.window_count = flat.window_count;
    p.shadow_mode = flat.shadow_mode;
    p.extinction = {float(o.me[0]), float(o.me[1]), float(o.me[2])};
    p.may_absorb = flat.absorbs || o.me[0] > 0 || o.me[1] > 0 || o.me[2] > 0;
    p.albedo = {float(o.ma[0]), float(o.ma[1]), float(o.ma[2])};
    p.eccentricity = float(o.mg);
    p.ab = o.ab;
    p.lr = o.lr;
    p.bv = o.bv;
    p.flags = (o.i ? PF_IRRADIANCE : 0u) | (o.dv ? PF_DV : 0u) | (flat.antimatter ? PF_ANTIMATTER : 0u) |
              (flat.sky_places ? PF_SKY_PLACES : 0u);
    p.st = float(o.st);
    p.ss = float(o.ss);
    p.dj = float(o.dj);
    p.ds = float(o.ds);
    p.lw = float(o.lw);
    p.least_lobe_prob = float(o.least_lobe_prob);
    p.samples_per_pass = p.spp = 1;
    p.skip_direct_below = uint32_t(std::max(1, o.direct_samples));
    return p;
}

// The radiance of a suffix vertex must not depend on the path that found it: on the media and antimatter crossed, or on
// the ray weight that -lw limits.
inline bool allows_path_reuse(const kernels::Params& par) {
    const bool mist = par.extinction.x > 0 || par.extinction.y > 0 || par.extinction.z > 0;
    return par.ab > 0 && par.lr <= 0 && par.least_lobe_prob == 0 && (par.flags & PF_ANTIMATTER) == 0 && !mist;
}

}  // namespace render
