// SPDX-License-Identifier: BSD-3-Clause
// The tables of a scene in two steps, of which skies share the first: its surfaces, then what shines from far away.
// A room ends with the last surface of the scene: a sky is what is read behind it.
#pragma once
#include <map>
#include <string>
#include <vector>
#include "flatten/flatten.h"
#include "flatten/modifiers.h"
#include "flatten/sources.h"

namespace flatten {

struct Room {
    size_t objects = 0;                           // number of the scene's
    FlatScene tables;                             // with sources that are surfaces, and no others
    ModifierLists modifiers;                      // of the objects
    std::map<std::string, uint32_t> arena_files;  // cal::Code.tables
    std::vector<Lights::Relay> relays;
};
Room flatten_room(const scene::Scene& scene, const Options& options, const scene::ReadOptions& files);
// scene: begins with the room's objects.
FlatScene add_distant(Room room, const scene::Scene& scene, const Options& options, const scene::ReadOptions& files);

}  // namespace flatten
