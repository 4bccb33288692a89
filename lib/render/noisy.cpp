// SPDX-License-Identifier: BSD-3-Clause
// See noisy.h.
#include "render/noisy.h"

#include <algorithm>
#include <cmath>

#include "image/picture.h"

namespace render {
using namespace kernels;

namespace {
constexpr uint32_t coarse = 4;                      // side in pixels of the blocks in which a few paths are traced
constexpr uint32_t enough_pixels = 1u << 15;        // above them blocks of pixels have the pilots of one
constexpr uint32_t paths = 4;                       // of each block
constexpr uint32_t samples_first = (3u << 30) + 1;  // numbers of the samples, which no frame uses
constexpr float as_if_normal = 1.45f;               // standard over mean absolute deviation of four normal samples
constexpr uint32_t most_spp = 64;

// Luminances of n samples of each pixel of the picture of p.
std::vector<float> sampled(device::Device& device, device::Params p, uint32_t mode, uint32_t n) {
    p.mode = mode;
    p.frame = samples_first;
    p.skip_direct_below = UINT32_MAX;  // diffuse paths hold no direct light
    p.samples_per_pass = n;
    std::vector<float> rgb, out;
    const uint32_t all = p.nx * p.ny * n, some = std::max(n, device.preferred_batch_size() / n * n);
    for (p.first = 0; p.first < all; p.first += p.path_count) {
        p.path_count = std::min(some, all - p.first);
        device.run(p, rgb);
        for (size_t i = 0; i < rgb.size(); i += 3) {
            const double y = image::luminance(&rgb[i]);
            out.push_back(std::fabs(y) < 1e18 ? float(y) : 0.0f);
        }
    }
    return out;
}

// Means of 3 x 3 values, with the edge repeated.
std::vector<float> smoothed(const std::vector<float>& values, int nx, int ny) {
    std::vector<float> out(values.size());
    for (int y = 0; y < ny; y++)
        for (int x = 0; x < nx; x++) {
            float sum = 0;
            for (int dy = -1; dy <= 1; dy++)
                for (int dx = -1; dx <= 1; dx++)
                    sum += values[size_t(std::clamp(y + dy, 0, ny - 1)) * nx + std::clamp(x + dx, 0, nx - 1)];
            out[size_t(y) * nx + x] = sum / 9;
        }
    return out;
}

// A picture of blocks of pixels.
struct Blocks {
    device::Params params;
    int nx, ny;  // of blocks
    Blocks(const device::Params& of, uint32_t side)
        : params(of), nx(int((of.nx + side - 1) / side)), ny(int((of.ny + side - 1) / side)) {
        params.nx = uint32_t(nx), params.ny = uint32_t(ny);
    }
    float at_pixel(const std::vector<float>& values, const device::Params& of, uint32_t x, uint32_t y) const {
        return values[size_t(y * uint32_t(ny) / of.ny) * size_t(nx) + x * uint32_t(nx) / of.nx];
    }
};

// Mean absolute deviation of the diffuse light of single paths, by block.  Not the root mean square, which one bright
// path of four would dominate.
std::vector<float> diffuse_deviation(device::Device& device, const Blocks& blocks) {
    const std::vector<float> light = sampled(device, blocks.params, MODE_FRAMES, paths);
    std::vector<float> deviation(light.size() / paths);
    for (size_t block = 0; block < deviation.size(); block++) {
        const float* of = &light[paths * block];
        float mean = 0, off = 0;
        for (uint32_t k = 0; k < paths; k++) mean += of[k] / paths;
        for (uint32_t k = 0; k < paths; k++) off += std::fabs(of[k] - mean) / paths;
        deviation[block] = as_if_normal * off;
    }
    return smoothed(deviation, blocks.nx, blocks.ny);
}

// Variance of the direct light of single samples, from two samples of each block and its neighbours.
std::vector<float> direct_variance(device::Device& device, const Blocks& blocks) {
    const std::vector<float> light = sampled(device, blocks.params, MODE_DIRECT, 2);
    std::vector<float> variance(light.size() / 2);
    for (size_t i = 0; i < variance.size(); i++) {
        const float off = light[2 * i] - light[2 * i + 1];
        variance[i] = off * off / 2;
    }
    return smoothed(variance, blocks.nx, blocks.ny);
}

// The power of two nearest to the ratio, within limits.
uint32_t spp_for(float deviation, float of_one) {
    if (deviation < .75f * least_spp * of_one) return 0;
    uint32_t spp = least_spp;
    while (spp < most_spp && deviation > 1.5f * float(spp) * of_one) spp *= 2;
    return spp;
}
}  // namespace

std::vector<uint32_t> spp_of_noisy(device::Device& device, const device::Params& base, double share) {
    const uint32_t side = base.nx * base.ny > enough_pixels ? 2 : 1;
    const Blocks of_direct(base, side), of_diffuse(base, side * coarse);
    const std::vector<float> diffuse = diffuse_deviation(device, of_diffuse),
                             direct = direct_variance(device, of_direct);
    std::vector<float> deviation;
    for (uint32_t y = 0; y < base.ny; y++)
        for (uint32_t x = 0; x < base.nx; x++) {
            const float d = of_diffuse.at_pixel(diffuse, base, x, y);
            deviation.push_back(std::sqrt(of_direct.at_pixel(direct, base, x, y) + d * d));
        }

    // The deviation for which one sample is due, such that the total is reached.
    constexpr double all_that_count = 1u << 31;  // paths of a pass have 32-bit numbers
    const double enough = std::min(share * double(deviation.size()), all_that_count);
    float high_one = *std::max_element(deviation.begin(), deviation.end()), low_one = 1e-9f * high_one;
    const auto fits = [&](float one) {
        double all = 0;
        for (const float d : deviation) all += spp_for(d, one);
        return all <= enough;
    };
    for (int step = 0; step < 24 && high_one > 0; step++) {
        const float one = std::sqrt(low_one) * std::sqrt(high_one);
        (fits(one) ? high_one : low_one) = one;
    }
    std::vector<uint32_t> spp(deviation.size(), 0);
    if (high_one > 0)
        for (size_t i = 0; i < spp.size(); i++) spp[i] = spp_for(deviation[i], high_one);
    return spp;
}

}  // namespace render
