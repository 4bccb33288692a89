// SPDX-License-Identifier: BSD-3-Clause
// See frame0.h.
#include "uncertainty/frame0.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
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

WIDE_LOOP void mean_of_nine(const float* values, const float* counts, size_t stride, size_t n, float* out) {
    for (size_t x = 0; x < n; ++x) {
        float sum = 0, pixels = 0;
        for (size_t j = 0; j < 3; ++j)
            for (size_t i = 0; i < 3; ++i) sum += values[j * stride + x + i], pixels += counts[j * stride + x + i];
        out[x] = sum / (pixels > 1 ? pixels : 1.f);
    }
}

std::vector<float> smoothed(const std::vector<float>& values, int width, int height, const std::vector<bool>& counts) {
    const size_t w = size_t(width), stride = w + 2;  // around the picture nothing counts
    std::vector<float> out(values.size()), counted(stride * (size_t(height) + 2)), one(counted.size());
    for (size_t i = 0; i < values.size(); ++i)
        if (counts[i]) counted[(i / w + 1) * stride + i % w + 1] = values[i], one[(i / w + 1) * stride + i % w + 1] = 1;
    for (size_t y = 0; y < size_t(height); ++y)
        mean_of_nine(&counted[y * stride], &one[y * stride], stride, w, &out[y * w]);
    return out;
}

WIDE_LOOP void add_share(double frames, double all, const float* grey, size_t n, double* mean) {
    for (size_t i = 0; i < n; ++i) mean[i] += frames * double(grey[i]) / all;
}

// To the sum of squares about the mean, and to that of products with the excess.
WIDE_LOOP void add_scatter(double frames, double excess, const float* grey, const double* mean, size_t n,
                           double* scatter, double* product) {
    for (size_t i = 0; i < n; ++i) {
        const double d = double(grey[i]) - mean[i], weighted = frames * d;
        scatter[i] += weighted * d, product[i] += weighted * excess;
    }
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
    const size_t pixels = counts.size();
    std::vector<double> grey(pixels), scatter(pixels), product(pixels);
    for (size_t p = 0; p < x.size(); ++p)
        add_share(double(parts[p].frames), n, parts[p].grey.data(), pixels, grey.data());
    for (size_t p = 0; p < x.size(); ++p)
        add_scatter(double(parts[p].frames), x[p] - mean, parts[p].grey.data(), grey.data(), pixels, scatter.data(),
                    product.data());
    std::vector<float> excess(pixels), slope(pixels), slope_squares(pixels);
    for (size_t i = 0; i < pixels; ++i) {
        const double rest = std::max(0.0, scatter[i] - product[i] * product[i] / squares) / double(x.size() - 2);
        slope[i] = float(product[i] / squares);
        slope_squares[i] = slope[i] * slope[i];
        excess[i] = float(product[i] * product[i] / squares / squares - rest / squares);
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

}  // namespace uncertainty
