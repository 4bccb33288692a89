// SPDX-License-Identifier: BSD-3-Clause
// Shapes drawn in the picture: rectangles, freehand polygons, mask pictures.  Their fields are in pixels.
#pragma once
#include "region/shape.h"

namespace region {

Field make_picture_shape(const Shape& shape, const Space& space);  // rect, polygon
Field make_mask_field(const Shape& shape, const Space& space);     // in where the mask is at least 1/2

// A mask picture as numbers 0..1, row 0 = top.
struct MaskPicture {
    int width = 0, height = 0;
    std::vector<float> values;
};
MaskPicture read_mask_picture(const Shape& shape);
// Its mean over each pixel of an nx x ny picture.
std::vector<float> resample(const MaskPicture& mask, int nx, int ny);

}  // namespace region
