// SPDX-License-Identifier: BSD-3-Clause
// Where a direction lies in a picture, and how much of it a solid angle covers there.
#pragma once
#include <cstdint>
#include <optional>
#include "view/view.h"

namespace render {

// A pixel's value is the mean radiance over its area A in the picture plane, so a point that represents the solid angle
// dw adds L dw / (A dw/dA).
struct PicturePlace {
    double X, Y;              // as in view.h
    double sr;                // dw of the whole picture there: dw/dA per A
    uint32_t pixel = 0;       // row from the top * nx + column
    float right = 0, up = 0;  // of the place from the pixel's centre, in pixels
};

// The place of a unit direction from the eye, in a pixel that shows it; `anywhere`: also beyond the picture's rim,
// without pixel.
std::optional<PicturePlace> place_of(const view::Projector& projector, base::Vec3 dir, int nx, int ny,
                                     bool anywhere = false);

constexpr double LARGEST_DRAWN = 64;  // pixels; larger sources are sampled well enough by rays

}  // namespace render
