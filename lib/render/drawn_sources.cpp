// SPDX-License-Identifier: BSD-3-Clause
// See drawn_sources.h.
#include "render/drawn_sources.h"

#include "flatten/pack.h"

namespace render {
using namespace kernels;

void DrawnSources::select(device::Device& device, flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                          const sampling::SmoothSurfaces& smooth, const view::View& view, bool straight, bool images,
                          Params& base) {
    const int nx = int(base.nx), ny = int(base.ny);
    view_ = view;
    straight_ = straight ? list_splatted_emitters(scene, tracer, view, nx, ny) : SplatList();
    images_ = images ? possible_images(scene, tracer, smooth, view, nx, ny) : SunImages();
    mark(device, scene);
    if (smooth.none()) return;
    try {
        if (smooth.curved && !images_.sources.empty()) find_curved_images(device, base, scene, smooth, view_, images_);
        keep_lit_images(device, base, view_, images_);
    } catch (const device::Cancelled&) {
        images_ = {};  // another view comes
    }
    if (images_.discs.empty()) images_ = {};
    mark(device, scene);
    write_discs(device, scene, base);
}

// Marks sources in place of those of the previous view.
void DrawnSources::mark(device::Device& device, flatten::FlatScene& scene) const {
    std::vector<uint32_t> marks(scene.source_count);
    for (const uint32_t i : straight_.sources) marks[i] |= SPLATTED_STRAIGHT;
    for (const uint32_t i : images_.sources) marks[i] |= SPLATTED_IMAGES;
    bool same = true;
    for (size_t i = 0; i < marks.size(); i++) {
        float& word = scene.f[scene.sources_at + SOURCE_FLOATS * i + SRC_SPLATTED];
        same = same && flatten::bits(word) == marks[i];
        word = flatten::from_bits(marks[i]);
    }
    if (!same) device.update_float_table(scene.sources_at, marks.size() * SOURCE_FLOATS);
}

void DrawnSources::write_discs(device::Device& device, flatten::FlatScene& scene, Params& base) const {
    float* table = &scene.f[scene.images_at];
    std::fill(table, table + MOST_IMAGES * IMAGE_FLOATS, 0.0f);
    for (size_t i = 0; i < images_.discs.size(); i++) {
        flatten::put(table + IMAGE_FLOATS * i + IMAGE_DIR, images_.discs[i].dir);
        table[IMAGE_FLOATS * i + IMAGE_CAP] = float(images_.discs[i].cap);
    }
    device.update_float_table(scene.images_at, size_t(MOST_IMAGES) * IMAGE_FLOATS);
    base.images_at = scene.images_at;
    base.image_count = uint32_t(images_.discs.size());
}

}  // namespace render
