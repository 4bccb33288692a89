// SPDX-License-Identifier: BSD-3-Clause
// Opens regions of the tools (vcmetrics -regions, ptrace -focus): masks (OpenEXR, written by vcregion) or a region
// file (man/vcregion.5), distinguished by their first bytes.
#pragma once
#include <string>
#include "image/masks.h"

namespace region {

// empty: a region without a pixel is an Error; empty_and_small: a region of few pixels is also warned of.
enum class Check { empty, empty_and_small, none };

// Returns masks; or, from a region file, their names, and in `draw` a function that draws them for a view and size.
// A region file without a region is an Error unless it may be empty.  read: gets the file, and those that it names.
image::MaskSet open(const std::string& path, image::DrawRegions& draw, Check check, bool may_be_empty = false,
                    base::FilesRead* read = nullptr);

}  // namespace region
