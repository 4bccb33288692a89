// SPDX-License-Identifier: BSD-3-Clause
// See loaded_scene.h.
#include "render/loaded_scene.h"

#include "render/fingerprint.h"
#include "sampling/suns.h"
#include "sampling/targets.h"

namespace render {

LoadedScene load_scene(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files) {
    flatten::FlatScene flat = flatten::flatten(scene, options, files);
    if (options.sampling != Sampling::plain) sampling::find_targets(flat);
    LoadedScene out;
    out.geometry = hash_of_geometry(flat);
    if (!sampling::suns_of(flat).empty()) out.smooth = sampling::smooth_surfaces(flat);
    flat.keep_tables_only();
    out.tables = std::make_shared<const flatten::FlatScene>(std::move(flat));
    return out;
}

}  // namespace render
