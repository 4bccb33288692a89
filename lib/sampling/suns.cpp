// SPDX-License-Identifier: BSD-3-Clause
// Suns among the active sources: distant ones that are no images of others (kernels/tables.h).
#include "sampling/suns.h"

#include "kernels/dialect/host.h"

namespace sampling {
using namespace kernels;

constexpr float SMALL_CAP = 0.001f;  // 1 - cosine of half the angle of a sun

std::vector<base::Vec3> suns_of(const flatten::FlatScene& scene) {
    std::vector<base::Vec3> suns;
    for (uint32_t i = 0; i < scene.source_count; i++) {
        const float* src = &scene.f[scene.sources_at + size_t(SOURCE_FLOATS) * i];
        if (as_uint_(src[SRC_KIND]) != SK_DISTANT || as_uint_(src[SRC_VIRTUAL]) != NONE) continue;
        if (src[SRC_CAP] < SMALL_CAP) suns.push_back({src[SRC_CENTRE], src[SRC_CENTRE + 1], src[SRC_CENTRE + 2]});
    }
    return suns;
}

}  // namespace sampling
