// SPDX-License-Identifier: BSD-3-Clause
// See frame0.h.
#include "uncertainty/frame0.h"

#include <algorithm>
#include <cmath>

namespace uncertainty {

std::vector<float> frame0_error(const std::vector<float>& half_off, int width, int height,
                                const std::vector<bool>& counts) {
    std::vector<float> out = half_off;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0, pixels = 0;
            for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
                    const size_t near = size_t(j) * size_t(width) + size_t(i);
                    if (counts[near]) sum += half_off[near] * half_off[near], pixels += 1;
                }
            float& of_pixel = out[size_t(y) * size_t(width) + size_t(x)];
            of_pixel = std::copysign(std::sqrt(sum / std::max(pixels, 1.f)), of_pixel);
        }
    return out;
}

double frame0_share(int64_t n, int64_t m) { return std::min(1.0, double(m) / double(n)); }

int random_sign(uint32_t pixel, int pair) {
    uint32_t x = pixel * 2654435761u + 40503u;  // a hash: all of its bits depend on all of the pixel's
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return (x >> (24 + pair)) & 1 ? 1 : -1;
}

}  // namespace uncertainty
