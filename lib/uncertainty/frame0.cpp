// SPDX-License-Identifier: BSD-3-Clause
// See frame0.h.
#include "uncertainty/frame0.h"

#include <algorithm>
#include <cmath>

#include "image/picture.h"

namespace uncertainty {

std::vector<float> frame0_error(const std::vector<image::Part>& frames, int width, int height,
                                const std::vector<bool>& counts) {
    const int n = int(frames.size());
    float first = 0;
    for (int k = 1; k <= n; ++k) first += image::in_first_half(k);
    const float second = float(n) - first, of_difference = (1 / first + 1 / second) / 4;
    std::vector<float> excess(counts.size()), out(counts.size());
    for (size_t i = 0; i < excess.size(); ++i) {
        float a = 0, b = 0, squares = 0;
        for (int k = 1; k <= n; ++k) (image::in_first_half(k) ? a : b) += frames[size_t(k - 1)].grey[i];
        a /= first, b /= second;
        for (int k = 1; k <= n; ++k) {
            const float d = frames[size_t(k - 1)].grey[i] - (image::in_first_half(k) ? a : b);
            squares += d * d;
        }
        excess[i] = (a - b) * (a - b) / 4 - of_difference * squares / float(n - 2);
        out[i] = a - b;
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0, pixels = 0;
            for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
                    const size_t near = size_t(j) * size_t(width) + size_t(i);
                    if (counts[near]) sum += excess[near], pixels += 1;
                }
            float& of_pixel = out[size_t(y) * size_t(width) + size_t(x)];
            of_pixel = std::copysign(std::sqrt(std::max(0.f, sum / std::max(pixels, 1.f))), of_pixel);
        }
    return out;
}

double missing_share(int64_t n) {
    constexpr double m = image::direct_samples;
    return double(n) < m ? 1 - 2 / double(n) : .75 * std::pow(m / double(n), 2);
}

int random_sign(uint32_t pixel, int pair) {
    uint32_t x = pixel * 2654435761u + 40503u;  // a hash: all of its bits depend on all of the pixel's
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return (x >> (24 + pair)) & 1 ? 1 : -1;
}

}  // namespace uncertainty
