// SPDX-License-Identifier: BSD-3-Clause
// Surfaces of a scene seen through each pixel's centre, and along any other ray of the view.
#pragma once
#include <vector>
#include "region/raster.h"

namespace region {

// The surfaces along one ray.
struct RayHits {
    static constexpr int room = 24;  // surfaces along a ray that are kept apart
    Point p;
    bool seen = false;          // the view has a ray here
    double begin = 0, end = 0;  // along p.dir from the eye: where the view begins, where something opaque ends it
    int n = 0;
    Crossing crossings[room];  // t from the eye as well
};

class PixelVisibility {
public:
    static constexpr int tile = 16;  // pixels

    PixelVisibility(const Space& space, const SceneView& eye);

    // Through a position of the picture, in pixels.
    RayHits trace(double x, double y) const;

    // At pixel centres, y from the bottom: the direction (zero: no ray), its end, and the list of surfaces hit.
    size_t at(int x, int y) const { return size_t(y) * size_t(nx_) + size_t(x); }
    const Vec3& direction(int x, int y) const { return directions_[at(x, y)]; }
    double end(int x, int y) const { return ends_[at(x, y)]; }
    uint32_t list(int x, int y) const { return list_of_[at(x, y)]; }
    // The lists met in a tile of pixels and in a rim of one pixel around it.
    const std::vector<uint32_t>& lists_in_tile(int x, int y) const {
        return tiles_[size_t(y / tile) * size_t(across_) + size_t(x / tile)];
    }
    // The different lists of surfaces that rays met; list 0 is empty (no ray).
    const std::vector<std::vector<unsigned>>& lists() const { return lists_; }

private:
    void trace_centres();
    void collect_tiles();

    const Space& space_;
    const SceneView& eye_;
    int nx_, ny_, across_ = 0;
    std::vector<std::vector<unsigned>> lists_;
    std::vector<Vec3> directions_;
    std::vector<double> ends_;
    std::vector<uint32_t> list_of_;
    std::vector<std::vector<uint32_t>> tiles_;
};

}  // namespace region
