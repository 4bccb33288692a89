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
    std::vector<float> f;
    kernels::SceneTables s = {};  // its pointer to f is set when all is there
    kernels::Params par = {};

    void put(kernels::float3 v) { f.insert(f.end(), {v.x, v.y, v.z}); }
    // A parallelogram about its centre (portals.h); u and v are its sides.  A polished one has a roughness and a
    // mirrored sun.
    void put_portal(kernels::float3 centre, kernels::float3 u, kernels::float3 v, kernels::float3 out,
                    float roughness = 0, kernels::float3 mirrored = {0, 0, 0}) {
        const kernels::float3 across = kernels::cross3(u, v);
        const float square = kernels::dot3(across, across);
        for (const kernels::float3 w : {centre, u, v, out}) put(w);
        const kernels::float3 along_u = kernels::scale3(kernels::cross3(v, across), 1 / square);
        const kernels::float3 along_v = kernels::scale3(kernels::cross3(across, u), 1 / square);
        put(along_u);
        put(along_v);
        f.insert(f.end(), {std::sqrt(square), roughness * roughness});
        const float down = kernels::dot3(mirrored, out), a = kernels::dot3(mirrored, along_u),
                    b = kernels::dot3(mirrored, along_v);
        put(kernels::sub3(mirrored, kernels::scale3(out, 2 * down)));
        f.insert(f.end(), {down, a, 1 / a, b, 1 / b});
    }
};
