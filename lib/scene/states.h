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

// The states of a Honeybee folder's aperture groups and dynamic shades as such words: those of the group of
// south..default..0.rad are south/0, south/1 ... by the numbers of its files.  files: of the scene, which has the first
// one of each.  Throws Error (place: the option) where there is none.
std::vector<std::string> honeybee_states(const std::vector<std::string>& files);

}  // namespace scene
