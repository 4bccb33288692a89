// SPDX-License-Identifier: BSD-3-Clause
// See hour_shares.h.
#include "device/hour_shares.h"

namespace device {
using namespace kernels;

void weigh_shares(uint32_t rounds, const float4* found, const float4* suffix_rad, float4* rad, HourPaths& out) {
    float pdfs[REUSE_SQUARE] = {};
    const auto of = [&](uint32_t round, uint32_t path, uint32_t m) {
        return found[(round * REUSE_SQUARE + path) * REUSE_GROUP + m];
    };
    const auto suffix = [](uint32_t round, uint32_t path, uint32_t m) {
        return reuse_member(path ^ REUSE_FIRST(round), m);
    };
    for (uint32_t round = 0; round < rounds; round++)
        for (uint32_t path = 0; path < REUSE_SQUARE; path++)
            for (uint32_t m = 0; m < REUSE_GROUP; m++) pdfs[suffix(round, path, m)] += of(round, path, m).w;
    if (out.shares_at.empty()) out.shares_at.push_back(0);
    for (uint32_t path = 0; path < REUSE_SQUARE; path++) {
        float3 light = F3(0.0f, 0.0f, 0.0f);
        for (uint32_t round = 0; round < rounds; round++)
            for (uint32_t m = 0; m < REUSE_GROUP; m++) {
                const uint32_t from = suffix(round, path, m);
                const float3 share = scale3(xyz4(of(round, path, m)), 1.0f / pdfs[from]);
                if (!(pdfs[from] > 0.0f && max3(share) > 0.0f)) continue;
                out.shares.push_back({from, {share.x, share.y, share.z}});
                light = add3(light, mul3(share, xyz4(suffix_rad[from])));
            }
        out.shares_at.push_back(out.shares.size());
        rad[path] = pack4(add3(xyz4(rad[path]), light), rad[path].w);
    }
}

}  // namespace device
