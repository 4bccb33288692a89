// SPDX-License-Identifier: BSD-3-Clause
// A polygon of the scene and its plane, the same for what is drawn and for what shines.
#pragma once
#include <vector>
#include "base/span.h"
#include "base/vec.h"

namespace flatten {

struct Polygon {
    std::vector<base::Vec3> corners;  // without a repeated last one
    base::Vec3 normal;
    double area = 0;  // 0: no plane

    explicit Polygon(const base::Span<double>& reals);
    // A triangle, or four corners in one plane that turn one way: drawn as a fan about the first corner.
    bool is_triangles() const;
    // The axis that the plane faces most: others than triangles are drawn in the mean plane (RADIANCE's), at the
    // corners' places along this axis.
    int axis() const;
    // normal . p of the mean plane
    double offset(base::Vec3 origin) const;
    std::vector<base::Vec3> drawn() const;
};

}  // namespace flatten
