// SPDX-License-Identifier: BSD-3-Clause
// The value of one pixel as the sum of all light that its paths gather, by vertex: `ptrace -pixel`.
#pragma once
#include <array>
#include <functional>
#include <map>
#include <string>
#include "device/recorded_paths.h"
#include "render/view_plan.h"
#include "scene/object.h"

namespace render {

// A vertex of a path, and light that the path gathers there.
struct PixelRow {
    int64_t frame = 0;
    std::string path;                      // which of the frame
    int vertex = 0;                        // its number on the path
    std::string surface, material, place;  // names, and where the surface stands: "office.rad:14"
    bool has_point = false;
    device::Rgb point{};
    std::string lobe;      // along which the path goes on
    device::Rgb weight{};  // of radiance from there in the pixel
    uint32_t bounces = 0;  // diffuse ones between vertex and eye
    std::string light;     // where light comes from; empty: none arrives
    device::Rgb rgb{};     // its contribution to the pixel
};
using GiveRow = std::function<void(const PixelRow&)>;

// Frames first .. last of a pixel, as ptaccum sums them: frame 0 and the mean of the others.  The contributions of all
// rows sum to its value.  scene: that of the plan, loaded with Options::names.  x, y: from the lower left corner.
void explain_pixel(device::Device& device, const ViewPlan& plan, const scene::Scene& scene, int x, int y, int64_t first,
                   int64_t last, const GiveRow& give);

// Moments of a pixel in frame 0 (image/moments.h), and the parts of each light in its variance, which sum to it.
struct MomentReport {
    std::array<double, 4> moments{};
    std::map<std::string, double> variance_by_light;
};
MomentReport explain_moments(device::Device& device, const ViewPlan& plan, const scene::Scene& scene, int x, int y);

}  // namespace render
