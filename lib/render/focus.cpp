// SPDX-License-Identifier: BSD-3-Clause
// See focus.h.
#include "render/focus.h"

#include <fmt/core.h>

#include <algorithm>
#include <map>

#include "base/error.h"

namespace render {

Focus focus_on(const image::MaskSet& masks, int width, int height, double share, const std::string& place) {
    if (masks.width != width || masks.height != height)
        base::fail(place, fmt::format("the picture has {} x {} pixels, the regions {} x {}", width, height, masks.width,
                                      masks.height));
    // Samples of a pixel and all samples of a pass have 32-bit numbers (kernels/integrator/begin.h).
    constexpr double most_spp = 1 << 24, most_samples = 1u << 31;
    const double each = std::min(share * width * height, most_samples) / double(masks.masks.size());
    std::vector<uint32_t> spp(size_t(width) * size_t(height), 1);
    for (const image::Mask& mask : masks.masks) {
        const auto covers = [](float coverage) { return coverage > 0; };
        const auto pixels = std::count_if(mask.coverage.begin(), mask.coverage.end(), covers);
        if (pixels == 0) base::fail(place, "region \"" + mask.name + "\" is empty");
        const auto some = uint32_t(std::clamp(each / double(pixels), 1.0, most_spp));
        for (size_t i = 0; i < spp.size(); i++)
            if (covers(mask.coverage[i])) spp[i] = std::max(spp[i], some);
    }

    std::map<uint32_t, FocusPart> parts;
    for (size_t i = 0; i < spp.size(); i++)
        if (spp[i] > 1) parts[spp[i]].pixels.push_back(uint32_t(i));
    Focus focus;
    for (auto& [number, part] : parts) {
        part.spp = number;
        focus.push_back(std::move(part));
    }
    return focus;
}

}  // namespace render
