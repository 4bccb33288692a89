// SPDX-License-Identifier: BSD-3-Clause
// -regions file: masks (OpenEXR, written by vcregion) or a region file (man/vcregion.5), distinguished by their first
// bytes.
#pragma once
#include <string>
#include "comfort/measure.h"
#include "image/masks.h"

// Masks; or, from a region file, their names and what draws them when view and size are known.
image::MaskSet open_regions(const std::string& path, comfort::DrawRegions& draw);
