// SPDX-License-Identifier: BSD-3-Clause
// See learn.h.
#include "render/learn.h"

#include <algorithm>

#include "render/noisy.h"
#include "sampling/mixture_weights.h"

namespace render {

namespace {
// Pixels with fewer than m samples in a frame show frame 0's in so many frames: as many times each half.  0: m is odd.
uint32_t frames_kept(int64_t m) { return m % 2 ? 0 : std::max(2u, uint32_t(m) / 16 * 2); }
}  // namespace

DiffusePlan learn(device::Device& device, const ViewPlan& plan) {
    DiffusePlan out{plan.sampling, {}};
    out.sampling.params = sampling::optimise_mixture(device, *plan.scene.tables, out.sampling.params);
    if (plan.noisy_share <= 0) return out;

    std::vector<uint32_t> spp = spp_of_noisy(device, out.sampling.params, plan.noisy_share);
    for (const Several& focus : out.sampling.several)  // pixels of a focus keep their number
        for (const kernels::FocusEntry& entry : focus.entries) spp[entry.pixel] = 0;
    for (const bool fewer : {false, true}) {
        Several some;
        some.spp = least_spp;
        some.direct_above = fewer ? frames_kept(plan.m) : 0;
        NoisyPixels noisy{{}, *some.direct_above};
        for (uint32_t pixel = 0; pixel < spp.size(); pixel++) {
            if (spp[pixel] == 0 || fewer != (spp[pixel] < uint32_t(plan.m))) continue;
            noisy.pixels.push_back(pixel);
            for (uint32_t from = 0; from < spp[pixel]; from += least_spp)
                some.entries.push_back({pixel, spp[pixel], from, 0, 0});
        }
        if (noisy.pixels.empty()) continue;
        out.sampling = with_several(std::move(out.sampling), std::move(some));
        out.noisy.push_back(std::move(noisy));
    }
    return out;
}

bool NoisyPixels::hold_direct(uint32_t pixel, int64_t frame) const {
    return frame > int64_t(direct_above) && std::binary_search(pixels.begin(), pixels.end(), pixel);
}

}  // namespace render
