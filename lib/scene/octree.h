// SPDX-License-Identifier: BSD-3-Clause
// Octrees (.oct) and what compiled meshes (.rtm) share with them.  The tree itself is read over: the tracer builds its
// own hierarchy.  Frozen octrees hold their primitives, others only the names of their scene files.
#pragma once
#include <string>
#include <vector>
#include "scene/binary.h"
#include "scene/builder.h"

namespace scene {

constexpr int octree_magic = 283, mesh_magic = 319;  // plus the size of an object index

struct Octree {
    std::vector<std::string> history;  // header lines that tell how it was made: oconv's command
    std::vector<std::string> files;    // none: frozen, read_objects() comes next
    int64_t objects = 0;
    int index_size = 4;
};
Octree read_octree(Binary& in);                           // from the header up to the end of the tree
int read_magic(Binary& in, int magic, const char* what);  // size of an object index, in bytes
void skip_tree(Binary& in, int index_size);

// The primitives of a frozen octree (as many as expected), or the modifiers of a mesh (expected = -1).
// Returns the object of the scene that each became; VOID: left out.
std::vector<int32_t> read_objects(Binary& in, int index_size, int64_t expected, SceneBuilder& builder);

}  // namespace scene
