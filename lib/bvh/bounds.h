// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes around primitives, for the builder of our trees and for Embree's callbacks.
#pragma once
#include <vector>
#include "bvh/build.h"

namespace bvh {

struct Bounds {
    float lo[3], hi[3];
};

Bounds empty_bounds();
void grow(Bounds& bounds, const float p[3]);  // throws Error for a coordinate that is not a number or too large

// Around shape k of the table, not padded.
Bounds shape_bounds(const Input& in, size_t k);

// Around primitive k of a tree: a triangle, a shape or an instance of one of `trees`, padded for the rounding of the
// intersection tests.  Empty (lo > hi) for an instance of nothing.
Bounds primitive_bounds(const Input& in, size_t k, const std::vector<Bounds>& trees);

}  // namespace bvh
