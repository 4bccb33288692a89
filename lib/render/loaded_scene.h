// SPDX-License-Identifier: BSD-3-Clause
// A scene as all stages of rendering take it: its tables, which nothing changes any more.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/files_read.h"
#include "base/hash.h"
#include "flatten/room.h"
#include "render/options.h"
#include "sampling/patches.h"
#include "sampling/smooth_planes.h"
#include "scene/object.h"

namespace render {

// What scenes have in common that differ in their sky.
struct LoadedRoom {
    std::string made_of;  // hash of objects and options
    base::FilesRead files;
    flatten::Room surfaces;
    std::vector<sampling::Target> windows;
    sampling::SmoothSurfaces smooth;
};

struct LoadedScene {
    std::shared_ptr<const flatten::FlatScene> tables;
    bool mirrors_sources = false;            // some of its surfaces make virtual sources
    base::Hash geometry;                     // of the fingerprint
    sampling::SmoothSurfaces smooth;         // that may mirror suns
    std::shared_ptr<const LoadedRoom> room;  // with RenderOptions::keep_room
    // By load() (setup.h):
    std::shared_ptr<const char> text;  // SceneText::id
    std::string made_by;               // hash of options
    std::vector<std::string> history;  // of the scene's files
};

// Flattens a scene and finds where its diffuse directions are to be aimed.  known: the room of another scene, or null;
// it is taken where it is the same.  Throws Error (unsupported input with file:line).
LoadedScene load_scene(const scene::Scene& scene, const RenderOptions& options, const scene::ReadOptions& files,
                       const std::shared_ptr<const LoadedRoom>& known = nullptr);

}  // namespace render
