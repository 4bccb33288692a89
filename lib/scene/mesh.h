// SPDX-License-Identifier: BSD-3-Clause
// Triangle meshes: RADIANCE's compiled ones (.rtm, with materials inside) and Wavefront .obj with usemtl, whose
// materials are names in the scene that uses the mesh.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "base/vec.h"
#include "scene/object.h"

namespace scene {

struct Mesh {
    // unit; 0 0 0 = none
    struct Normal {
        float x, y, z;
    };
    // 0 0 where there are none
    struct Uv {
        float u, v;
    };
    struct Triangle {
        uint32_t v[3];     // right-handed: the front is where they run counter-clockwise
        int32_t material;  // see below; VOID = none
    };
    // Triangles from `first` on, as far as the next group's.
    struct Group {
        size_t first;
        std::string name;  // empty: none
        uint32_t line;
    };
    std::string path;
    std::vector<base::Vec3> positions;
    std::vector<Normal> normals;  // empty, or one per position
    std::vector<Uv> uvs;          // empty, or one per position
    std::vector<Triangle> triangles;
    std::vector<Group> groups;                // .obj: what its o or g names
    Scene materials;                          // .rtm: Triangle::material is an index into its objects
    std::vector<uint32_t> material_lines;     // where each of them is first named
    std::vector<std::string> material_names;  // .obj: Triangle::material is an index into these (lookup_modifier() in
                                              // the scene of the mesh primitive); empty for .rtm
};

// By content (.rtm) or ending (.obj).  Throws Error; sizes are checked against what the file holds.  by: as for
// base::open_file().
Mesh read_mesh(const std::string& path, const Limits& limits = {}, const base::Opener& by = {});

}  // namespace scene
