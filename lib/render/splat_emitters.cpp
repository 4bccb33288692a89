// SPDX-License-Identifier: BSD-3-Clause
// A pixel's value is the mean radiance over its area A in the picture plane, so a point that represents the solid angle
// dw adds L dw / (A dw/dA), with dw/dA of the projection at that point by central differences.
#include "render/splat_emitters.h"

#include <cmath>

#include "base/angle.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"
#include "view/density.h"

namespace render {
namespace {
using namespace kernels;
using base::Vec3;
using flatten::bits;
using flatten::from_bits;

constexpr double LARGEST = 64;     // pixels; larger sources are sampled well enough by rays
constexpr uint32_t POINTS = 4096;  // per source: at a pixel's edge the error is about 1/POINTS^(3/4) of the source
constexpr uint32_t MOST_RAYS = 1u << 20;

// A pixel, y from the bottom, across the rim of an angular fisheye's circle of 180 degrees, or next to it: it shows
// what lies ahead of the eye.
bool crosses_rim(const view::Projector& p, int x, int y, int nx, int ny) {
    const view::View& v = p.view();
    const auto centre = p.direction((x + .5) / nx, (y + .5) / ny);
    if (v.type != 'a' || v.vh > 180 || v.vv > 180 || !centre) return false;
    return dot(*centre, p.forward()) > -std::hypot(v.vh / nx, v.vv / ny) / 2 * base::degree;
}
}  // namespace

void mark_splatted(const SplatList& list, std::vector<float>& table, bool drawn) {
    for (uint32_t at : list.marked) table[at] = from_bits(drawn ? 1u : 0u);
}

SplatList list_splatted_emitters(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const view::View& view, int nx, int ny) {
    SplatList out;
    if (view.type == 'l') return out;  // parallel views have no eye point
    const view::Projector projector(view);
    const double fore = view.vo, aft = view.va;
    std::vector<uint32_t> taken;
    for (uint32_t i = 0; i < scene.source_count; i++) {
        const float* q = &scene.f[scene.sources_at + SOURCE_FLOATS * i];
        const uint32_t kind = bits(q[SRC_KIND]);
        if (q[SRC_MAXRAD] > 0 || bits(q[SRC_CLASS]) == M_ILLUM || bits(q[SRC_VIRTUAL]) != NONE) continue;
        if (kind == SK_DISTANT ? aft > 0 : (fore > 0 || aft > 0)) continue;  // clipping: left to rays
        const auto mid = tracer.source_point(i, view.vp, 0.5, 0.5);
        double X, Y;
        if (mid.solid_angle <= 0 || !projector.locate_direction(mid.dir, X, Y)) continue;
        const double d = view::solid_angle_density(projector, X, Y);
        if (d <= 0 || mid.solid_angle / d * nx * ny > LARGEST) continue;
        taken.push_back(i);
    }
    if (taken.empty()) return out;
    const uint32_t points = std::max<uint32_t>(16, std::min<uint32_t>(POINTS, MOST_RAYS / uint32_t(taken.size())));
    for (uint32_t i : taken) {
        out.marked.push_back(scene.sources_at + SOURCE_FLOATS * i + SRC_SPLATTED);
        const uint32_t kind = bits(scene.f[scene.sources_at + SOURCE_FLOATS * i + SRC_KIND]);
        for (uint32_t k = 0; k < points; k++) {
            // Roberts' R2 sequence: uniform in both numbers for any count
            const double x = std::fmod(0.5 + (k + 1) * 0.7548776662466927, 1.0),
                         y = std::fmod(0.5 + (k + 1) * 0.5698402909980532, 1.0);
            const auto p = tracer.source_point(i, view.vp, x, y);
            double X, Y;
            if (p.solid_angle <= 0 || !projector.locate_direction(p.dir, X, Y)) continue;
            if (X < 0 || X >= 1 || Y < 0 || Y >= 1) continue;
            const double d = view::solid_angle_density(projector, X, Y);
            if (d <= 0) continue;
            const uint32_t column = uint32_t(X * nx), row = uint32_t(ny - 1 - int(Y * ny));
            if (dot(p.dir, projector.forward()) < 0 && crosses_rim(projector, int(column), int(Y * ny), nx, ny))
                continue;
            const Vec3 o =
                kind == SK_DISTANT && fore > 0 ? view.vp + p.dir * fore - scene.centre : view.vp - scene.centre;
            device::SplatRay r;
            for (int c = 0; c < 3; c++) {
                r.org[c] = float(o[c]);
                r.dir[c] = float(p.dir[c]);
            }
            r.dist = float(p.dist);
            r.weight = float(p.solid_angle / points / d * nx * ny);
            r.source = i;
            out.rays.push_back(r);
            out.pixel.push_back(row * uint32_t(nx) + column);
            out.right.push_back(float(X * nx - column - .5));
            out.up.push_back(float(Y * ny - int(Y * ny) - .5));
        }
    }
    return out;
}

}  // namespace render
