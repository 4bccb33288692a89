// SPDX-License-Identifier: BSD-3-Clause
// A picture a person can check: the scene toned for the eye, each region tinted and outlined in a colour of
// its own, the names below in the same colours.
#pragma once
#include <string>
#include "image/masks.h"
#include "image/picture.h"

namespace region {
// Colours are dealt out in the order of the regions; the same size is needed.  Whole or not at all.
void write_preview(const std::string& png_path, const image::Picture& under, const image::MaskSet& set);
}  // namespace region
