// SPDX-License-Identifier: BSD-3-Clause
// See learn.h.
#include "render/learn.h"

#include "render/noisy.h"
#include "sampling/mixture_weights.h"

namespace render {

DiffusePlan learn(device::Device& device, const ViewPlan& plan, const Probes& probes) {
    DiffusePlan out{plan.sampling, std::vector<uint32_t>(size_t(plan.sampling.params.nx) * plan.sampling.params.ny, 1)};
    out.sampling.params = sampling::optimise_mixture(device, *plan.scene.tables, out.sampling.params);
    std::vector<bool> of_focus(out.spp.size());  // whose pixels keep their number
    for (const Several& focus : out.sampling.several)
        for (size_t at = 0; at < focus.entries.size(); at += FOCUS_WORDS) {
            const uint32_t pixel = focus.entries[at + FOCUS_PIXEL];
            out.spp[pixel] = focus.entries[at + FOCUS_ALL], of_focus[pixel] = true;
        }
    if (plan.noisy_share <= 0) return out;

    const std::vector<uint32_t> spp = spp_of_noisy(device, out.sampling.params, plan.noisy_share, probes.variance);
    Several noisy;
    noisy.spp = least_spp;
    for (uint32_t pixel = 0; pixel < spp.size(); pixel++) {
        if (spp[pixel] == 0 || of_focus[pixel]) continue;
        out.spp[pixel] = spp[pixel];
        for (uint32_t from = 0; from < spp[pixel]; from += least_spp)
            noisy.entries.insert(noisy.entries.end(), {pixel, spp[pixel], from});
    }
    if (!noisy.entries.empty()) out.sampling = with_several(std::move(out.sampling), std::move(noisy));
    return out;
}

}  // namespace render
