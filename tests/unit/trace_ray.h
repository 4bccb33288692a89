// SPDX-License-Identifier: BSD-3-Clause
// Samples of a single ray, all classes of light (MODE_RAY), as rtrace gives them.
#pragma once
#include <algorithm>
#include <cmath>

#include "unit/renderer.h"
#include "sampling/mixture_weights.h"

namespace render {

struct RayValue {
    double mean[3], error[3];  // error: standard error
};

constexpr float RAY_REST = 0.3f;  // light from other directions, over portals': a single ray does not repay pilots

// The ray is in world coordinates.
inline RayValue trace_ray(const Renderer& renderer, const double origin[3], const double dir[3], int64_t n) {
    using namespace kernels;
    device::Params p = renderer.plan().sampling.params;
    p.mode = MODE_RAY;
    p.flags |= PF_EYE_ON_SURFACE;
    sampling::pick_all_portals(uint32_t(renderer.plan().scene.tables->portals.size()), 1, RAY_REST, p);
    const base::Vec3 d = base::unit({dir[0], dir[1], dir[2]});
    p.ray_org = {float(origin[0] - p.centre.x), float(origin[1] - p.centre.y), float(origin[2] - p.centre.z)};
    p.ray_dir = {float(d.x), float(d.y), float(d.z)};
    double sum[3] = {}, square[3] = {};
    std::vector<float> rgb;
    for (int64_t done = 0; done < n;) {
        p.frame = uint32_t(done);
        p.first = 0;
        p.path_count = uint32_t(std::min<int64_t>(n - done, 1 << 16));
        renderer.device().run(p, rgb);
        scrub(rgb);
        for (size_t i = 0; i < rgb.size(); i++) {
            sum[i % 3] += rgb[i];
            square[i % 3] += double(rgb[i]) * rgb[i];
        }
        done += p.path_count;
    }
    RayValue v;
    for (int c = 0; c < 3; c++) {
        v.mean[c] = sum[c] / double(n);
        const double var = n > 1 ? (square[c] / double(n) - v.mean[c] * v.mean[c]) * double(n) / double(n - 1) : 0;
        v.error[c] = std::sqrt(std::max(0.0, var) / double(n));
    }
    return v;
}

}  // namespace render
