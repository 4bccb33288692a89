// SPDX-License-Identifier: BSD-3-Clause
// A pixel for the probe, as JSON: radiance, luminance, direction, solid angle, Guth's position index.
#pragma once
#include <string>
#include "image/picture.h"

namespace live {

// x from the left, y from the top.  Empty: no such pixel.
std::string pixel_facts(const image::Picture& picture, int x, int y);

}  // namespace live
