// SPDX-License-Identifier: BSD-3-Clause
// The surfaces that the eye sees at a place of the picture, by name: "what" of ptrace -control.
#pragma once
#include <string>
#include "render/loaded_scene.h"
#include "view/view.h"

namespace render {

// x, y: fractions of the picture from its lower left corner.  Clear surfaces from the eye on, and the one at which the
// eye's ray ends; at most five.  If that is a slat, also the pane behind it, which is not seen there.  Each is eight
// fields with tabs between them: name, type, place, material, its type and place, point or direction, its real
// arguments if they are few; a flat, clear surface has four corners there.  A face of a mesh has the name of its group.
// Empty: nothing is seen there.  scene: from which the tables were made, with Options::names.
std::string seen_at(const LoadedScene& loaded, const scene::Scene& scene, const view::View& view, double x, double y);

}  // namespace render
