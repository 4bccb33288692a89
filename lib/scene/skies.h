// SPDX-License-Identifier: BSD-3-Clause
// Suns and skies: light from far away (`source`), of which a picture wants one of each.  A sun is narrower than 5
// degrees: a light of any power, or a glow of 1 W/m2 or more (others are lamps far away).  A sky is wider: of glow,
// light or illum.
#pragma once
#include "scene/object.h"

namespace scene {

// Throws Error (place: file and line) where the scene has a sun or a sky, which a weather file is to give.
void require_no_sky(const Scene& scene);

// Throws Error where the objects from `first` on bring a second sun, or a sky over a part of the sky that there is.
void require_one_sky(const Scene& scene, size_t first);

// Warns where skies of two files cover the same.
void warn_of_two_skies(const Scene& scene);

}  // namespace scene
