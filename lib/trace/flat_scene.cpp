// SPDX-License-Identifier: BSD-3-Clause
// flatten(): modifiers, geometry, sources, in this order, into one pair of arenas.
#include "trace/flat_scene.h"

#include "trace/flatten.h"

namespace trace {

FlatScene flatten(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files) {
    FlatScene out;
    Flattener f(scene, options, files, out);
    f.flatten_modifiers();
    // .cal code stands first in both arenas: its addresses are absolute
    out.u = std::move(f.code.words);
    out.f = std::move(f.code.floats);
    const uint32_t args_at = uint32_t(out.f.size());
    out.f.insert(out.f.end(), f.args.begin(), f.args.end());
    for (size_t i = 0; i < f.mods.size(); i += MOD_WORDS) f.mods[i + MOD_ARGS] += args_at;
    out.mods_at = uint32_t(out.u.size());
    out.u.insert(out.u.end(), f.mods.begin(), f.mods.end());
    f.flatten_geometry();
    f.flatten_sources();
    return out;
}

}  // namespace trace
