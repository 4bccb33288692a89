// SPDX-License-Identifier: BSD-3-Clause
// A folder in the layout of honeybee-radiance as a scene (its command: translate model-to-rad-folder).
#pragma once
#include <string>
#include <vector>
#include "base/find_file.h"

namespace base {

// These scene files, each folder among them replaced by the files that Honeybee makes an octree of: scene, apertures,
// luminaires, and aperture groups and dynamic shades in their first state.  Adds the folders of all files to the search
// path, and of a folder the one that holds it, from which BSDF files are named (model/bsdf/x.xml).
std::vector<std::string> open_folders(const std::vector<std::string>& files, ReadOptions& options);

}  // namespace base
