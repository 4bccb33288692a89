// SPDX-License-Identifier: BSD-3-Clause
// See drawn_sources.h.
#include "render/drawn_sources.h"

#include "flatten/pack.h"

namespace render {
using namespace kernels;

DrawnSources find_drawn_sources(device::Device& device, const LoadedScene& scene, const flatten::HostTracer& tracer,
                                const view::View& view, bool straight, bool images, const device::Params& par) {
    const int nx = int(par.nx), ny = int(par.ny);
    const flatten::FlatScene& flat = *scene.tables;
    DrawnSources out;
    if (straight) out.straight = list_splatted_emitters(flat, tracer, view, nx, ny);
    if (!images || scene.smooth.none()) return out;
    SunImages found = possible_images(flat, tracer, scene.smooth, view, nx, ny);
    const device::Params marked = device::with_view(par, view_tables({out.straight, {{}, found.sources, 1}}, flat));
    try {
        if (scene.smooth.curved && !found.sources.empty())
            find_curved_images(device, marked, flat, scene.smooth, view, found);
        keep_lit_images(device, marked, view, found);
        if (!found.discs.empty()) out.images = std::move(found);
    } catch (const device::Cancelled&) {}  // another view comes
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
