// SPDX-License-Identifier: BSD-3-Clause
// See drawn_sources.h.
#include "render/drawn_sources.h"

#include <cmath>

#include "flatten/pack.h"
#include "kernels/dialect/host.h"
#include "render/picture_place.h"
#include "sampling/suns.h"

namespace render {
using namespace kernels;
namespace {

using base::Vec3;

constexpr uint32_t POINTS = 4096;  // per source: at a pixel's edge the error is about 1/POINTS^(3/4) of the source
constexpr uint32_t MOST_RAYS = 1u << 20;

// Points spread evenly over small bright sources (the sun's disc is 1.4 pixels wide at 512), which few rays would hit:
// each is added to the pixel that it falls in.  The sources that are small in this view, and their rays.
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

}  // namespace

DrawnSources find_drawn_sources(device::Device& device, const LoadedScene& scene, const flatten::HostTracer& tracer,
                                const view::View& view, bool straight, bool images, const device::Params& par) {
    const int nx = int(par.nx), ny = int(par.ny);
    const flatten::FlatScene& flat = *scene.tables;
    DrawnSources out;
    if (straight) out.straight = list_splatted_emitters(flat, tracer, view, nx, ny);
    if (!images || scene.smooth.none() || sampling::suns_of(flat).empty()) return out;
    SunImages found = possible_images(flat, tracer, scene.smooth, view, nx, ny);
    const device::Params marked = device::with_view(par, view_tables({out.straight, {{}, found.sources, 1}}, flat));
    if (scene.smooth.curved && !found.sources.empty())
        find_curved_images(device, marked, flat, scene.smooth, view, found);
    keep_lit_images(device, marked, view, found);
    if (!found.discs.empty()) out.images = std::move(found);
    return out;
}

ViewTables view_tables(const DrawnSources& drawn, const flatten::FlatScene& scene) {
    ViewTables out;
    out.drawn.resize(scene.sources.size());
    for (const uint32_t i : drawn.straight.sources) out.drawn[i] |= DRAWN_STRAIGHT;
    for (const uint32_t i : drawn.images.sources) out.drawn[i] |= DRAWN_IMAGES;
    for (const SunImages::Disc& disc : drawn.images.discs)
        out.sun_images.push_back({flatten::packed(disc.dir), float(disc.cap)});
    return out;
}

}  // namespace render
