// SPDX-License-Identifier: BSD-3-Clause
// A scene's tables as the kernels read them, for tests of what aims at windows and highlights: filled by hand.
#pragma once
#include <cmath>
#include <vector>
#include "kernels/dialect/host.h"
namespace kernels {
#include "kernels/bvh/instance.h"
#include "kernels/geom/surface.h"
#include "kernels/sampling/mixture.h"
}  // namespace kernels

struct Tables {
    std::vector<kernels::Portal> portals;
    std::vector<kernels::Highlight> highlights;
    kernels::SceneTables s = {};
    kernels::Params par = {};

    static kernels::Packed3 packed(kernels::float3 v) { return {v.x, v.y, v.z}; }
    // A parallelogram about its centre (portals.h); u and v are its sides.  A polished one has a roughness and a
    // mirrored sun.
    void put_portal(kernels::float3 centre, kernels::float3 u, kernels::float3 v, kernels::float3 out,
                    float roughness = 0, kernels::float3 mirrored = {0, 0, 0}) {
        const kernels::float3 across = kernels::cross3(u, v);
        const float square = kernels::dot3(across, across);
        const kernels::float3 along_u = kernels::scale3(kernels::cross3(v, across), 1 / square);
        const kernels::float3 along_v = kernels::scale3(kernels::cross3(across, u), 1 / square);
        const float down = kernels::dot3(mirrored, out), a = kernels::dot3(mirrored, along_u),
                    b = kernels::dot3(mirrored, along_v);
        const kernels::float3 sun = kernels::sub3(mirrored, kernels::scale3(out, 2 * down));
        portals.push_back({packed(centre), packed(u), packed(v), packed(out), packed(along_u), packed(along_v),
                           std::sqrt(square), roughness * roughness, packed(sun), down, a, 1 / a, b, 1 / b});
        s.portals = portals.data();
    }
};
