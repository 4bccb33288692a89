// SPDX-License-Identifier: BSD-3-Clause
// What pictures of many hours are made of (docs/decisions/0042): light per radiance of the skies and suns, from paths
// that are traced once.
#pragma once
#include <vector>
#include "render/samples.h"

namespace render {

// A response to a sun, over its solid angle, in half precision: there are many.
struct SunFactor {
    uint16_t sun, rgb[3];
};
constexpr size_t most_suns = 65536;
void unpack(const SunFactor& factor, float* rgb);

// The paths of a pass.  Without path reuse path p is sample p % samples of pixel p / samples of the pass.
struct PathFactors {
    uint32_t samples = 1;  // of each pixel
    std::vector<device::SkyShare> sky;
    std::vector<uint64_t> suns_at;  // as HourPaths::suns_at
    std::vector<SunFactor> suns;
    std::vector<float> shares;     // as HourPaths::shares; empty: no path reuse
    std::vector<uint32_t> sample;  // with path reuse: of each path, in `rest`; NONE outside the picture
    std::vector<float> rest;       // 3 floats a sample, by pixel: the same in all hours

    uint64_t bytes() const;
};
// par: with PF_HOURS; samples: consecutive paths of a pixel.
PathFactors draw_factors(device::Device& device, const device::Params& par, uint32_t samples);

}  // namespace render
