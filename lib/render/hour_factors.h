// SPDX-License-Identifier: BSD-3-Clause
// What pictures of many hours are made of (docs/decisions/0042): light per radiance of the skies and suns, from paths
// that are traced once.
#pragma once
#include <memory>
#include <vector>
#include "render/samples.h"

namespace render {

// In half precision, because there are many: the response to an hour's sun over its solid angle, or the share in the
// light of a suffix vertex.
struct Factor {
    uint16_t of, rgb[3];
};
constexpr size_t most_hours = 65536;
void unpack(const Factor& factor, float* rgb);

// The paths of a pass.  Without path reuse path p is sample p % samples of pixel p / samples of the pass.
struct PathFactors {
    uint32_t samples = 1;  // of each pixel
    std::vector<device::SkyShare> sky;
    std::vector<uint64_t> suns_at;  // as HourPaths::suns_at
    std::vector<Factor> suns;       // of each list in the order of their hours
    // With path reuse, else empty:
    std::vector<uint64_t> shares_at;  // as HourPaths::shares_at
    std::vector<Factor> shares;
    std::vector<uint32_t> sample;  // of each path, in `rest`; NONE outside the picture
    std::vector<float> rest;       // 3 floats a sample, by pixel: the same in all hours
    // With PF_GATHERS: the irradiances of the suffix vertices, whose pixels are the paths.
    std::unique_ptr<const PathFactors> gathered;

    uint64_t bytes() const;
};
// par: with PF_HOURS; samples: consecutive paths of a pixel; hour_of_sun: of those of par.
PathFactors draw_factors(device::Device& device, const device::Params& par, uint32_t samples,
                         const std::vector<uint32_t>& hour_of_sun);

}  // namespace render
