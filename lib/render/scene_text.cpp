// SPDX-License-Identifier: BSD-3-Clause
// See scene_text.h.
#include "render/scene_text.h"

#include "flatten/surfaces.h"

namespace render {

SceneText read_room(const std::vector<std::string>& files, const scene::ReadOptions& how, bool more) {
    SceneText text;
    text.scene = scene::read_scene(files, how);
    text.room = scene::extent_of(text.scene);
    if (more) text.room_hash = scene::hash_of_objects(text.scene, flatten::surfaces_end(text.scene)).text();
    return text;
}

SceneText with_sky(SceneText text, const std::string& sky, scene::ReadOptions how) {
    scene::cut(text.scene, text.room);
    how.asked_by.clear();  // a sky is the command line's
    if (!sky.empty()) scene::read_more(text.scene, {sky}, how);
    text.id = std::make_shared<char>();
    return text;
}

}  // namespace render
