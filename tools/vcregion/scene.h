// SPDX-License-Identifier: BSD-3-Clause
// The scene as regions see it.  scene_traced.cpp asks lib/trace; scene_none.cpp stands in where it is not built.
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/find_file.h"
#include "region/region.h"

// Nothing if there are no files.
std::unique_ptr<region::SceneView> open_scene(const std::vector<std::string>& files, const base::ReadOptions& options);
