// SPDX-License-Identifier: BSD-3-Clause
// A pixel's value is the mean radiance over its area A in the picture plane, so a point that represents the solid angle
// dw adds L dw / (A dw/dA), with dw/dA of the projection at that point by central differences.
#include "render/splat_emitters.h"

#include <cmath>

#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace render {
namespace {
using namespace kernels;
using base::Vec3;
using flatten::bits;
using flatten::from_bits;

constexpr double LARGEST = 64;     // pixels; larger sources are sampled well enough by rays
constexpr uint32_t POINTS = 4096;  // per source: at a pixel's edge the error is about 1/POINTS^(3/4) of the source
constexpr uint32_t MOST_RAYS = 1u << 20;

// Solid angle per unit picture area at (X,Y); 0 outside the view.
double density(const view::Projector& p, double X, double Y) {
    const double h = 1e-4;
    const auto c = p.direction(X, Y);
    if (!c) return 0;
    const auto slope = [&](double dx, double dy) {
        const auto a = p.direction(X + dx, Y + dy), b = p.direction(X - dx, Y - dy);
        if (a && b) return (*a - *b) * (1 / (2 * h));
        if (a) return (*a - *c) * (1 / h);
        if (b) return (*c - *b) * (1 / h);
        return Vec3{};
    };
    return length(cross(slope(h, 0), slope(0, h)));
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
        const double d = density(projector, X, Y);
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
            const double d = density(projector, X, Y);
            if (d <= 0) continue;
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
            const uint32_t column = uint32_t(X * nx), row = uint32_t(ny - 1 - int(Y * ny));
            out.pixel.push_back(row * uint32_t(nx) + column);
            out.right.push_back(float(X * nx - column - .5));
            out.up.push_back(float(Y * ny - int(Y * ny) - .5));
        }
    }
    return out;
}

}  // namespace render
