// SPDX-License-Identifier: BSD-3-Clause
// Means of frames over blocks of a picture, where noise is averaged enough to see a bias.
#pragma once
#include <vector>
#include "unit/renderer.h"

namespace laws {

// Green of the frames first .. last of a square picture: the mean of each of n x n blocks and, last, of the picture.
inline std::vector<double> block_means(render::Renderer& renderer, int size, int n, int first, int last) {
    const int side = size / n;
    const double frames = double(last - first + 1);
    std::vector<double> out(size_t(n * n) + 1);
    renderer.frames(first, last - first + 1, [&](int64_t, const std::vector<float>& rgb, const image::Moments&) {
        for (int i = 0; i < size * size; i++) {
            const double v = rgb[3 * size_t(i) + 1] / frames;
            out.back() += v / (size * size);
            out[size_t(i / size / side * n + i % size / side)] += v / (side * side);
        }
        return true;
    });
    return out;
}

}  // namespace laws
