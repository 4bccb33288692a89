// SPDX-License-Identifier: BSD-3-Clause
// See splat_emitters.h.
#include "render/splat_emitters.h"

#include <cmath>

#include "flatten/pack.h"
#include "kernels/dialect/host.h"
#include "render/picture_place.h"

namespace render {
namespace {
using namespace kernels;
using base::Vec3;
using flatten::bits;
using flatten::from_bits;

constexpr uint32_t POINTS = 4096;  // per source: at a pixel's edge the error is about 1/POINTS^(3/4) of the source
constexpr uint32_t MOST_RAYS = 1u << 20;
}  // namespace

SplatList list_splatted_emitters(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const view::View& view, int nx, int ny) {
    SplatList out;
    if (view.type == 'l') return out;  // parallel views have no eye point
    const view::Projector projector(view);
    const double fore = view.vo, aft = view.va;
    std::vector<uint32_t> taken;
    for (uint32_t i = 0; i < scene.sources.size(); i++) {
        const Source& q = scene.sources[i];
        const uint32_t kind = q.kind;
        if (q.max_radius > 0 || q.light_type == M_ILLUM || q.relay != NONE) continue;
        if (kind == SK_DISTANT ? aft > 0 : (fore > 0 || aft > 0)) continue;  // clipping: left to rays
        const auto mid = tracer.source_point(i, view.vp, 0.5, 0.5);
        if (mid.solid_angle <= 0) continue;
        const auto place = place_of(projector, mid.dir, nx, ny, true);
        if (!place || mid.solid_angle / place->sr * nx * ny > LARGEST_DRAWN) continue;
        taken.push_back(i);
    }
    if (taken.empty()) return out;
    const uint32_t points = std::max<uint32_t>(16, std::min<uint32_t>(POINTS, MOST_RAYS / uint32_t(taken.size())));
    for (uint32_t i : taken) {
        out.sources.push_back(i);
        const uint32_t kind = scene.sources[i].kind;
        for (uint32_t k = 0; k < points; k++) {
            // Roberts' R2 sequence: uniform in both numbers for any count
            const double x = std::fmod(0.5 + (k + 1) * 0.7548776662466927, 1.0),
                         y = std::fmod(0.5 + (k + 1) * 0.5698402909980532, 1.0);
            const auto p = tracer.source_point(i, view.vp, x, y);
            if (p.solid_angle <= 0) continue;
            const auto place = place_of(projector, p.dir, nx, ny);
            if (!place) continue;
            const Vec3 o =
                kind == SK_DISTANT && fore > 0 ? view.vp + p.dir * fore - scene.centre : view.vp - scene.centre;
            device::SplatRay r;
            for (int c = 0; c < 3; c++) {
                r.org[c] = float(o[c]);
                r.dir[c] = float(p.dir[c]);
            }
            r.dist = float(p.dist);
            r.weight = float(p.solid_angle / points / place->sr * nx * ny);
            r.source = i;
            out.rays.push_back(r);
            out.pixel.push_back(place->pixel);
            out.right.push_back(place->right);
            out.up.push_back(place->up);
        }
    }
    return out;
}

}  // namespace render
