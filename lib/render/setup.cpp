// SPDX-License-Identifier: BSD-3-Clause
// See setup.h.
#include "render/setup.h"

#include <algorithm>

#include "base/hash.h"
#include "flatten/band_colours.h"
#include "flatten/surfaces.h"

namespace render {
namespace {

// The options on which the tables depend.
std::string made_by(const Setup& setup) {
    const RenderOptions& o = setup.options;
    base::Hash hash;
    hash.add({uint64_t(o.dr), o.bv, o.any_reflectance, o.sampling == Sampling::plain});
    for (const std::string& file : setup.reading.cal_files) hash.add_all(file);
    if (o.bands) hash.add_all(o.bands->name);
    return hash.text();
}

// The origin of the tables, too, must not depend on views before.
bool is_near(const LoadedScene& scene, const RenderView& view) {
    const flatten::Viewpoint from = viewpoint_of(view);
    return flatten::centre_of(scene.tables->boxes, &from) == scene.tables->centre;
}

}  // namespace

Setup preview_of(Setup setup) {
    constexpr int most = 128;
    int &nx = setup.view.nx, &ny = setup.view.ny;
    const int longest = std::max({nx, ny, most});
    nx = std::max(1, nx * most / longest);
    ny = std::max(1, ny * most / longest);
    setup.view.focus.clear();
    setup.options.direct_samples = 2;
    setup.options.more_if_small = false;
    setup.options.noisy_share = 0;
    return setup;
}

LoadedScene load(const device::Device& device, const SceneText& text, const Setup& setup, const LoadedScene& before) {
    const std::string options_hash = made_by(setup);
    if (before.tables && before.text == text.id && before.made_by == options_hash && is_near(before, setup.view))
        return before;
    RenderOptions options = setup.options;
    options.eye = viewpoint_of(setup.view);
    options.room_text = text.room_hash;
    if (!text.room_hash.empty() && flatten::surfaces_end(text.scene) > text.room.objects)  // a sky with surfaces
        options.room_text = scene::hash_of_objects(text.scene, flatten::surfaces_end(text.scene)).text();
    options.sky_from = text.room.objects;
    if (before.tables) options.known = before.tables->built;
    options.compact_tree = device.compact_tree();
    LoadedScene scene = load_scene(text.scene, options, setup.reading, before.room);
    scene.text = text.id;
    scene.made_by = options_hash;
    scene.history = text.scene.history;
    return scene;
}

ViewPlan plan_picture(device::Device& device, const SceneText& text, const Setup& setup, const ViewPlan& before) {
    return plan_view(device, load(device, text, setup, before.scene), setup.view, setup.options);
}

}  // namespace render
