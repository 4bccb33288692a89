// SPDX-License-Identifier: BSD-3-Clause
// What tools take for regions (vcmetrics -regions, ptrace -focus): masks (OpenEXR, written by vcregion) or a region
// file (man/vcregion.5), distinguished by their first bytes.
#pragma once
#include <string>
#include "image/masks.h"

namespace region {

// Masks; or, from a region file, their names and what draws them when view and size are known, which fails where one is
// empty.  warn_of_small: and warns of those of few pixels.
image::MaskSet open(const std::string& path, image::DrawRegions& draw, bool warn_of_small);

}  // namespace region
