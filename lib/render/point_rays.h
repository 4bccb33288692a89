// SPDX-License-Identifier: BSD-3-Clause
// Pictures of points (ptrace -points).  A sensor's path begins on it as on a white diffuse surface, so that its pixel
// is its irradiance; else a pixel is the radiance along the point's ray.
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "flatten/flat_scene.h"
#include "image/points.h"
#include "kernels/dialect/host.h"

namespace render {

struct PointList {
    std::vector<image::Point> points;
    bool sensors = true;
    std::string hash;  // of the points
};

// The picture that the device renders: neighbours among its points share paths (kernels/integrator/path_reuse.h), so
// the groups of pixels are groups of neighbours.  Few points have several pixels each.
struct PointLayout {
    static constexpr uint32_t none = 0xffffffff;
    uint32_t nx = 0, ny = 0;
    std::vector<uint32_t> point;     // of each pixel, or none
    uint32_t copies = 0;             // pixels of each point
    uint32_t samples_per_frame = 1;  // of each pixel
};
PointLayout lay_out(const std::vector<image::Point>& points);

// A ray for each pixel.
std::vector<kernels::PointRay> point_rays(const PointList& list, const PointLayout& layout,
                                          const flatten::FlatScene& scene);

// Reorders layout pixels into a points' picture of `pixels` pixels; 3 floats each.
std::vector<float> in_order(const PointLayout& layout, const std::vector<float>& rgb, size_t pixels);

}  // namespace render
