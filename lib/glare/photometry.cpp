// SPDX-License-Identifier: BSD-3-Clause
// Sums in four lanes, the maximum in eight (photometry.h).
#include "glare/photometry.h"
#include <algorithm>
#include "base/wide.h"

namespace glare {
namespace {

// Sums over pixels: grey times omega cos, and grey times omega.
struct Light {
    double eye = 0, all = 0;
};

WIDE_LOOP Light light_of(const Luminance& lum, const Geometry& g) {
    Light sum{0, 0};
    for (int r = 0; r < g.height; ++r)
        for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s) {
            const size_t first = size_t(r) * g.width, end = first + g.spans[s].end;
            double e[4] = {}, f[4] = {};
            size_t i = first + g.spans[s].begin;
            for (; i + 4 <= end; i += 4)
                for (int k = 0; k < 4; ++k) {
                    e[k] += lum.grey[i + k] * g.omega_cos[i + k];
                    f[k] += lum.grey[i + k] * g.omega[i + k];
                }
            for (; i < end; ++i) {
                e[0] += lum.grey[i] * g.omega_cos[i];
                f[0] += lum.grey[i] * g.omega[i];
            }
            sum.eye += (e[0] + e[1]) + (e[2] + e[3]);
            sum.all += (f[0] + f[1]) + (f[2] + f[3]);
        }
    return sum;
}

WIDE_LOOP float largest_grey(const Luminance& lum, const Geometry& g) {
    float top[8] = {};
    for (int r = 0; r < g.height; ++r)
        for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s) {
            const float* row = lum.grey + size_t(r) * g.width;
            int x = g.spans[s].begin;
            for (; x + 8 <= g.spans[s].end; x += 8)
                for (int k = 0; k < 8; ++k) top[k] = std::max(top[k], row[x + k]);
            for (; x < g.spans[s].end; ++x) top[0] = std::max(top[0], row[x]);
        }
    return *std::max_element(top, top + 8);
}

}  // namespace

Photometry photometry(const Luminance& lum, const Geometry& g) {
    const Light light = light_of(lum, g);
    Photometry out;
    out.ev = cdm2_per_grey * light.eye;
    out.omega = g.omega_sum;
    out.mean_lum = cdm2_per_grey * light.all / g.omega_sum;
    out.max_lum = cdm2_per_grey * largest_grey(lum, g);
    out.valid_pixels = g.valid_count;
    return out;
}

}  // namespace glare
