// SPDX-License-Identifier: BSD-3-Clause
// Means of like neighbours for pixels in doubt (calm.h).
#include "comfort/calm.h"

#include <algorithm>
#include <cmath>

#include "comfort/luminance.h"

namespace comfort {
namespace {

constexpr float doubt = 2.5f;  // standard errors from the threshold
constexpr float likeness = 8;  // q = 1 at sqrt 8 standard errors of the difference
constexpr uint32_t how_far_of = 8;

// How far errors lie off, in standard errors: the middles of eight equally likely parts of a half normal distribution,
// scaled to a mean square of 1.
constexpr float how_far[how_far_of] = {.082f, .247f, .419f, .603f, .808f, 1.051f, 1.371f, 1.938f};

// Pixels to each side of the neighbourhood, which shall not be wider than evalglare's search radius by default.
int radius_of(const Geometry& geometry) {
    constexpr double widest_rad = 0.1;
    const double pitch = std::sqrt(geometry.omega_sum / double(std::max(1L, geometry.valid_count)));
    return std::min(2, int(widest_rad / (2 * pitch)));
}

}  // namespace

void Calm::take(const Halves& halves, const Geometry& geometry, double threshold_cdm2) {
    const std::vector<float>& noisy = halves.whole();
    radius_ = radius_of(geometry);
    find_variance(halves, geometry);
    mean_ = noisy;
    sway_.assign(noisy.size(), 0);
    doubtful_.clear();
    const float threshold = grey_limit(threshold_cdm2);
    uint32_t random = 1;
    for (int r = 0; r < geometry.height; ++r)
        for (size_t s = geometry.row_spans[r]; s < geometry.row_spans[r + 1]; ++s)
            for (int x = geometry.spans[s].begin; x < geometry.spans[s].end; ++x) {
                const size_t i = size_t(r) * geometry.width + x;
                const float off = noisy[i] - threshold;
                if (off * off > doubt * doubt * variance_[i]) continue;
                average(i, noisy, geometry);
                doubtful_.push_back(uint32_t(i));
                random = random * 1664525u + 1013904223u;
                sway_[i] *= how_far[random >> 29];
            }
}

// The half's own, or the mean of the neighbourhood if that is larger.
void Calm::find_variance(const Halves& halves, const Geometry& geometry) {
    const std::vector<float>& off = halves.off();
    const int w = geometry.width, h = geometry.height;
    rows_.resize(off.size());
    variance_.resize(off.size());
    for (size_t i = 0; i < off.size(); ++i) variance_[i] = off[i] * off[i];
    for (int y = 0; y < h; ++y) {
        const float* own = &variance_[size_t(y) * w];
        float* mean = &rows_[size_t(y) * w];
        for (int x = 0; x < w; ++x) {
            const int first = std::max(0, x - radius_), last = std::min(w - 1, x + radius_);
            float sum = 0;
            for (int k = first; k <= last; ++k) sum += own[k];
            mean[x] = sum / float(last - first + 1);
        }
    }
    std::vector<float> sum(w);
    for (int y = 0; y < h; ++y) {
        const int first = std::max(0, y - radius_), last = std::min(h - 1, y + radius_);
        std::fill(sum.begin(), sum.end(), 0.f);
        for (int k = first; k <= last; ++k)
            for (int x = 0; x < w; ++x) sum[x] += rows_[size_t(k) * w + x];
        float* v = &variance_[size_t(y) * w];
        for (int x = 0; x < w; ++x) v[x] = std::max(v[x], sum[x] / float(last - first + 1));
    }
}

// Of one pixel: its mean, and in sway_ the error of that.
void Calm::average(size_t pixel, const std::vector<float>& noisy, const Geometry& geometry) {
    const int w = geometry.width, h = geometry.height, x = int(pixel % w), y = int(pixel / w);
    const float own = noisy[pixel], variance = variance_[pixel];
    float weights = 0, sum = 0, errors = 0;
    for (int r = std::max(0, y - radius_); r <= std::min(h - 1, y + radius_); ++r)
        for (int c = std::max(0, x - radius_); c <= std::min(w - 1, x + radius_); ++c) {
            const size_t j = size_t(r) * w + c;
            if (!geometry.valid(j)) continue;
            const float d = noisy[j] - own, left = likeness * (variance + variance_[j]) - d * d;
            if (left < 0) continue;
            const float share = left > 0 ? left / (left + d * d) : 1, weight = share * share;
            weights += weight, sum += weight * noisy[j], errors += weight * weight * variance_[j];
        }
    mean_[pixel] = sum / weights;
    sway_[pixel] = std::sqrt(errors) / weights;
}

}  // namespace comfort
