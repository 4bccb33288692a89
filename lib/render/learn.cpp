// SPDX-License-Identifier: BSD-3-Clause
// See learn.h.
#include "render/learn.h"

#include "render/noisy.h"
#include "sampling/mixture_weights.h"

namespace render {

DiffusePlan learn(device::Device& device, const ViewPlan& plan) {
    DiffusePlan out{plan.sampling, {}};
    out.sampling.params = sampling::optimise_mixture(device, *plan.scene.tables, out.sampling.params);
    if (plan.noisy_share <= 0) return out;

    std::vector<uint32_t> spp = spp_of_noisy(device, out.sampling.params, plan.noisy_share);
    for (const Several& focus : out.sampling.several)  // pixels of a focus keep their number
        for (const kernels::FocusEntry& entry : focus.entries) spp[entry.pixel] = 0;
    Several noisy;
    noisy.spp = least_spp;
    noisy.direct_in_each_frame = true;
    for (uint32_t pixel = 0; pixel < spp.size(); pixel++) {
        if (spp[pixel] > 0) out.noisy.push_back(pixel);
        for (uint32_t from = 0; from < spp[pixel]; from += least_spp)
            noisy.entries.push_back({pixel, spp[pixel], from});
    }
    if (!out.noisy.empty()) out.sampling = with_several(std::move(out.sampling), std::move(noisy));
    return out;
}

}  // namespace render
