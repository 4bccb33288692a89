// SPDX-License-Identifier: BSD-3-Clause
// Rays against geometry by Embree's own traversal, the oracle for kernels/bvh/bvh8.h and bvh_compact.h.  Triangles are
// Embree's (ROBUST); analytic shapes go through callbacks to kernels/geom/shapes.h; instances are Embree's.  Ties
// between coincident surfaces are decided by Embree, not by the lower primitive.
#pragma once
#include <cstdint>
#include <memory>
#include "bvh/build.h"

namespace bvh {

class EmbreeScene {
public:
    // as kernels/bvh/intersect.h; prim 0xffffffff: none
    struct Hit {
        float t;
        uint32_t prim;
        float u, v;
        uint32_t inst;
    };
    // Takes what build8() takes; shapes, their ids and polygon_uv must outlive it, the rest is copied.
    // For measurements: robust = false takes Embree's faster kernels, which leak at edges; classes = false leaves out
    // the callbacks that tell opaque from transparent triangles.
    explicit EmbreeScene(const Input* trees, size_t tree_count = 1, bool robust = true, bool classes = true);
    ~EmbreeScene();
    Hit closest(const float org[3], float tmin, const float dir[3], float tmax, uint32_t mask) const;
    bool any(const float org[3], float tmin, const float dir[3], float tmax, uint32_t mask) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace bvh
