// SPDX-License-Identifier: BSD-3-Clause
// A scene as it was read: the room, then its sky, which another one may replace.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "scene/extent.h"
#include "scene/object.h"

namespace render {

struct SceneText {
    scene::Scene scene;
    scene::Extent room;                                         // where the sky begins
    std::string room_hash;                                      // of the surfaces before it; empty: nothing comes after
    std::shared_ptr<const char> id = std::make_shared<char>();  // of this reading
};

// Reads the files of a room.  more: other skies or edits may follow.
SceneText read_room(const std::vector<std::string>& files, const scene::ReadOptions& how, bool more);
// Reads this sky (a file, or as scene::read_more() takes it; empty: none) in place of the one before.
SceneText with_sky(SceneText text, const std::string& sky, scene::ReadOptions how);

}  // namespace render
