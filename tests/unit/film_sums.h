// SPDX-License-Identifier: BSD-3-Clause
// Frames, sums of them and merged sums, for tests of both.
#pragma once
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>
#include "film/accumulate.h"
#include "temp_folder.h"

// Frame k of a seed: noise with a heavy tail and negative values; frame 0 holds a sun.
inline image::Picture frame(int64_t k, uint64_t seed = 1) {
    image::Picture p;
    p.width = 6;
    p.height = 5;
    p.header.seed = seed;
    p.header.frame = k;
    uint32_t state = uint32_t(seed * 7919 + uint64_t(k) * 104729 + 1);
    for (int i = 0; i < 90; ++i) {
        state = state * 1664525u + 1013904223u;
        const double u = (state >> 8) / 16777216.;
        p.rgb.push_back(k == 0 ? (i == 4 ? 1e7f : float(u)) : float(std::pow(u, 4) * 20 - 1));
    }
    return p;
}

inline image::Picture sum_of(int64_t first, int64_t last, uint64_t seed = 1) {
    film::Accumulator a;
    for (int64_t k = first; k <= last; ++k) a.add(frame(k, seed), "x");
    image::Picture p;
    a.result(p, true);
    return p;
}

inline double worst(const image::Picture& a, const image::Picture& b) {
    double w = 0;
    for (size_t i = 0; i < a.rgb.size(); ++i)
        w = std::max(w, std::fabs(double(a.rgb[i]) - b.rgb[i]) / std::max(1., std::fabs(double(a.rgb[i]))));
    return w;
}

inline std::string merge_error(const std::vector<image::Picture>& parts) {
    return error_text([&] {
        film::Merger m;
        for (size_t i = 0; i < parts.size(); ++i) m.add(parts[i], "p" + std::to_string(i));
        m.result();
    });
}

inline image::Picture merged(const std::vector<image::Picture>& parts) {
    film::Merger m;
    for (const image::Picture& p : parts) m.add(p, "part");
    return m.result();
}
