// SPDX-License-Identifier: BSD-3-Clause
// States of what moves in a scene, such as blinds: the scene with some files more, or with some in place of others.
//     open                              the scene as it is
//     half=half.rad                     with one file more
//     shut=-south.rad +south_shut.rad   with one in place of another
//     tilt45=!genblinds ...             with what a command writes
//     south/half=half.rad               a state of the group "south"
// Names of files with blanks stand in quotes.
#pragma once
#include <string>
#include <vector>

namespace scene {

struct State {
    std::string name;                // "half"; of groups "south/half+west/shut"; empty: there are none
    std::vector<std::string> files;  // as read_scene() takes them
};

constexpr size_t most_states = 64;

// The states of all groups combined, the last group's the fastest; in the order of the words.  A file stands where the
// first one that it replaces stood, else at the end.  files: of the scene.  Throws Error (place: -state).
std::vector<State> states_of(const std::vector<std::string>& words, const std::vector<std::string>& files);

}  // namespace scene
