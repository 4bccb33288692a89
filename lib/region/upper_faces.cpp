// SPDX-License-Identifier: BSD-3-Clause
// See upper_faces.h.
#include "region/upper_faces.h"

#include <algorithm>
#include <cmath>

namespace region {
using base::Vec3;

namespace {

constexpr double LEVEL = .99, UPRIGHT = .1;  // vertical part of the normal
constexpr double NEAR = 1e-4;                // of a face's height or width: at the same height

struct Face {
    const std::vector<Vec3>* corners;
    Vec3 low, high;
    double tilt;  // of the normal: 1 lies flat, 0 stands upright
};

Face face_of(const std::vector<Vec3>& corners) {
    Face f{&corners, corners[0], corners[0], 0};
    const Vec3 area = area_of(corners);
    f.tilt = base::length(area) > 0 ? std::fabs(area.z) / base::length(area) : .5;
    for (const Vec3& c : corners) {
        f.low = {std::min(f.low.x, c.x), std::min(f.low.y, c.y), std::min(f.low.z, c.z)};
        f.high = {std::max(f.high.x, c.x), std::max(f.high.y, c.y), std::max(f.high.z, c.z)};
    }
    return f;
}

bool lies_below(const Face& f, const Face& over) {
    const double x = (f.low.x + f.high.x) / 2, y = (f.low.y + f.high.y) / 2;
    return over.low.z > f.low.z && over.low.x < x && x < over.high.x && over.low.y < y && y < over.high.y;
}

// Does an upright face reach from one level to the other?
bool joins(const Face& side, const Face& f, const Face& over) {
    const double near = NEAR * base::length(f.high - f.low);
    return std::fabs(side.low.z - f.low.z) <= near && std::fabs(side.high.z - over.high.z) <= near;
}

}  // namespace

Vec3 area_of(const std::vector<Vec3>& c) {
    Vec3 sum;
    for (size_t i = 0; i < c.size(); ++i) sum = sum + cross(c[i] - c[0], c[(i + 1) % c.size()] - c[0]);
    return sum;
}

std::vector<std::vector<Vec3>> upper_faces(const std::vector<std::vector<Vec3>>& faces) {
    std::vector<Face> flat, upright;
    for (const auto& corners : faces) {
        const Face f = face_of(corners);
        if (f.tilt > LEVEL) flat.push_back(f);
        else if (f.tilt < UPRIGHT) upright.push_back(f);
    }
    if (flat.empty() || upright.empty()) return faces;
    std::vector<std::vector<Vec3>> kept;
    for (const auto& corners : faces) {
        const Face f = face_of(corners);
        const bool closes =
            f.tilt > LEVEL && std::any_of(flat.begin(), flat.end(), [&](const Face& over) {
                return lies_below(f, over) && std::any_of(upright.begin(), upright.end(),
                                                          [&](const Face& side) { return joins(side, f, over); });
            });
        if (!closes && f.tilt >= UPRIGHT) kept.push_back(corners);
    }
    return kept;
}

}  // namespace region
