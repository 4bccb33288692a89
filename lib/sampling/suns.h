// SPDX-License-Identifier: BSD-3-Clause
// Suns among the active sources: distant and small ones that are no images of others (kernels/tables.h).
#pragma once
#include <vector>
#include "flatten/flat_scene.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace sampling {

constexpr float SMALL_CAP = 0.001f;  // 1 - cosine of half the angle of a sun

// Unit directions toward them.
inline std::vector<base::Vec3> suns_of(const flatten::FlatScene& scene) {
    std::vector<base::Vec3> suns;
    for (const kernels::Source& source : scene.sources)
        if (source.kind == SK_DISTANT && source.relay == NONE && source.cap < SMALL_CAP)
            suns.push_back(flatten::vec_of(source.centre));
    return suns;
}

}  // namespace sampling
