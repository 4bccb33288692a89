// SPDX-License-Identifier: BSD-3-Clause
// A scene that is read in parts, of which the first stays: where the part ends, whether two are the same.
#pragma once
#include "base/hash.h"
#include "scene/object.h"

namespace scene {

struct Extent {
    size_t objects = 0, files = 0, strings = 0, names = 0, history = 0, reals = 0;
};
Extent extent_of(const Scene& scene);
// Leaves what was there at that time.
void cut(Scene& scene, const Extent& end);

// Of the first objects: everything about them but the comments and the spelling of values.
base::Hash hash_of_objects(const Scene& scene, size_t count);

}  // namespace scene
