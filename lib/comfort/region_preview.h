// SPDX-License-Identifier: BSD-3-Clause
// A picture a person can check: the scene in grey-toned colours, each region tinted and outlined in a colour of its own.
#pragma once
#include <string>
#include "image/masks.h"
#include "image/picture.h"

namespace region {
// Colours are dealt out in the order of the regions; the same size is needed.  Whole or not at all.
void write_preview(const std::string& png_path, const image::Picture& under, const image::MaskSet& set);
}
