// SPDX-License-Identifier: BSD-3-Clause
// Files that instance and mesh primitives name, read once each.  Octrees that hold themselves, directly or through
// others, are refused here, so that users may follow instances without a guard.
#pragma once
#include <map>
#include <memory>
#include <string>
#include "scene/mesh.h"

namespace scene {

class Assets {
public:
    explicit Assets(const ReadOptions& options, const Limits& limits = {}) : options_(options), limits_(limits) {}
    // The file (first string) of an instance or mesh primitive of this scene, found along RAYPATH.  The references stay
    // valid as long as this object.  Errors name the primitive's place.
    const Scene& octree(const Scene& scene, const Object& instance);
    const Mesh& mesh(const Scene& scene, const Object& mesh);
    // The transform in the strings after the file name.
    static Xform transform(const Scene& scene, const Object& instance_or_mesh);

private:
    const Scene& load(const std::string& path, const std::string& place, int depth);
    ReadOptions options_;
    Limits limits_;
    std::map<std::string, std::unique_ptr<Scene>> octrees_;  // null while it is being read
    std::map<std::string, std::unique_ptr<Mesh>> meshes_;
};

}  // namespace scene
