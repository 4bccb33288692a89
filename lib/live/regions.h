// SPDX-License-Identifier: BSD-3-Clause
// Outlines of the regions of a file in a picture, as JSON.
#pragma once
#include <string>
#include "image/picture.h"

namespace live {

// Is there anything but comments?
bool holds_regions(const std::string& text, const std::string& path);

// [{"name":, "colour":[r,g,b], "rings":[[x,y,x,y,...],...]} or with "trouble": why there are no rings, ...].  Throws
// Error where the file is none of vcregion(5).
std::string region_outlines(const std::string& text, const std::string& path, const image::Picture& picture);

}  // namespace live
