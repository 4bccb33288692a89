// SPDX-License-Identifier: BSD-3-Clause
// See frame0.h.
#include "uncertainty/frame0.h"

#include <algorithm>
#include <cmath>

#include "image/picture.h"

namespace uncertainty {

namespace {
// Sum of the signs of frames 1 to k, of which m have one.
int signs_up_to(int64_t k, int64_t m) {
    k = std::min(k, m);
    return k % 2 == 0 ? 0 : image::in_first_half(k) ? 1 : -1;
}

// For each part: the number of its frames that show the first half, less those that show the second, over all of its
// frames.  Parts stand in the order of their first frames; those wholly above m are left out.  Empty: not one run's.
std::vector<double> excess_of_first(const std::vector<image::Part>& parts, int64_t m) {
    std::vector<double> out;
    for (const image::Part& p : parts) {
        if (p.from.size() != 1 || p.from[0].first != parts[0].from[0].first) return {};
        if (p.from[0].second[0].first > m) break;
        double signs = 0;
        for (const auto& [first, last] : p.from[0].second) signs += signs_up_to(last, m) - signs_up_to(first - 1, m);
        out.push_back(signs / double(p.frames));
    }
    return out;
}

std::vector<float> smoothed(const std::vector<float>& values, int width, int height, const std::vector<bool>& counts) {
    std::vector<float> out(values.size());
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float sum = 0, pixels = 0;
            for (int j = std::max(0, y - 1); j <= std::min(height - 1, y + 1); ++j)
                for (int i = std::max(0, x - 1); i <= std::min(width - 1, x + 1); ++i) {
                    const size_t near = size_t(j) * size_t(width) + size_t(i);
                    if (counts[near]) sum += values[near], pixels += 1;
                }
            out[size_t(y) * size_t(width) + size_t(x)] = sum / std::max(pixels, 1.f);
        }
    return out;
}
}  // namespace

Frame0Error frame0_error(const std::vector<image::Part>& parts, int64_t m, int width, int height,
                         const std::vector<bool>& counts) {
    const std::vector<double> x = excess_of_first(parts, m);
    if (x.size() < 3) return {};
    double n = 0, mean = 0, squares = 0;
    for (size_t p = 0; p < x.size(); ++p) n += double(parts[p].frames), mean += double(parts[p].frames) * x[p];
    mean /= n;
    for (size_t p = 0; p < x.size(); ++p) squares += double(parts[p].frames) * (x[p] - mean) * (x[p] - mean);
    if (!(squares > 0)) return {};
    std::vector<float> excess(counts.size()), slope(counts.size()), slope_squares(counts.size());
    for (size_t i = 0; i < excess.size(); ++i) {
        double grey = 0, scatter = 0, product = 0;
        for (size_t p = 0; p < x.size(); ++p) grey += double(parts[p].frames) * double(parts[p].grey[i]) / n;
        for (size_t p = 0; p < x.size(); ++p) {
            const double d = double(parts[p].grey[i]) - grey, weight = double(parts[p].frames);
            scatter += weight * d * d, product += weight * d * (x[p] - mean);
        }
        const double rest = std::max(0.0, scatter - product * product / squares) / double(x.size() - 2);
        slope[i] = float(product / squares);
        slope_squares[i] = slope[i] * slope[i];
        excess[i] = float(product * product / squares / squares - rest / squares);
    }
    excess = smoothed(excess, width, height, counts), slope_squares = smoothed(slope_squares, width, height, counts);
    for (size_t i = 0; i < slope.size(); ++i)
        if (slope[i] != 0) slope[i] *= std::sqrt(std::max(0.f, excess[i] / slope_squares[i]));
    return {std::move(slope), m};
}

double missing_share(int64_t n, int64_t m) {
    const double seen = 2 / double(std::min({n, m, int64_t(image::most_parts)}));
    return (1 - seen) * std::pow(double(std::min(n, m)) / double(n), 2);
}

int random_sign(uint32_t pixel, int pair) {
    uint32_t x = pixel * 2654435761u + 40503u;  // a hash: all of its bits depend on all of the pixel's
    x = (x ^ (x >> 16)) * 0x85ebca6bu;
    x = (x ^ (x >> 13)) * 0xc2b2ae35u;
    return (x >> (24 + pair)) & 1 ? 1 : -1;
}

}  // namespace uncertainty
