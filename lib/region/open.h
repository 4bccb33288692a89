// SPDX-License-Identifier: BSD-3-Clause
// Opens regions of the tools (vcmetrics -regions, ptrace -focus): masks (OpenEXR, written by vcregion) or a region
// file (man/vcregion.5), distinguished by their first bytes.
#pragma once
#include <string>
#include "image/masks.h"

namespace region {

// Returns masks; or, from a region file, their names, and in `draw` a function that draws them for a view and size and
// throws Error if one is empty.  warn_of_small: the function also warns of regions of few pixels.
image::MaskSet open(const std::string& path, image::DrawRegions& draw, bool warn_of_small);

}  // namespace region
