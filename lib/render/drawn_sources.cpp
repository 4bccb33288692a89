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
    device::Params marked = par;
    marked.view_table =
        std::make_shared<const std::vector<uint32_t>>(view_words({out.straight, {{}, found.sources, 1}}, flat, marked));
    try {
        if (scene.smooth.curved && !found.sources.empty())
            find_curved_images(device, marked, flat, scene.smooth, view, found);
        keep_lit_images(device, marked, view, found);
        if (!found.discs.empty()) out.images = std::move(found);
    } catch (const device::Cancelled&) {}  // another view comes
    return out;
}

std::vector<uint32_t> view_words(const DrawnSources& drawn, const flatten::FlatScene& scene, Params& par) {
    std::vector<uint32_t> words(scene.sources.size());
    for (const uint32_t i : drawn.straight.sources) words[i] |= DRAWN_STRAIGHT;
    for (const uint32_t i : drawn.images.sources) words[i] |= DRAWN_IMAGES;
    par.drawn_count = uint32_t(words.size());
    par.images_at = uint32_t(words.size());
    par.image_count = uint32_t(drawn.images.discs.size());
    for (const SunImages::Disc& disc : drawn.images.discs)
        for (const double value : {disc.dir.x, disc.dir.y, disc.dir.z, disc.cap})
            words.push_back(flatten::bits(float(value)));
    return words;
}

}  // namespace render
