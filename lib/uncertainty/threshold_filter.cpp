// SPDX-License-Identifier: BSD-3-Clause
// See threshold_filter.h.
#include "uncertainty/threshold_filter.h"

#include <algorithm>

namespace uncertainty {
namespace {

constexpr float ambiguous = 2.5f;  // standard errors from the threshold
constexpr float likeness = 8;      // weight 0 at sqrt 8 standard errors of the difference

// The variance of a pixel, or the mean of those around it if that is larger: where few samples are bright, pixels
// without such a sample seem to have none.
std::vector<float> pooled(const ThresholdFilter::Image& image, int radius) {
    const int w = image.width, h = image.height;
    std::vector<float> sums(size_t(w) * size_t(h)), counts(sums.size()), out(sums.size());
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int i = std::max(0, x - radius); i <= std::min(w - 1, x + radius); ++i) {
                const float v = image.variance[size_t(y) * size_t(w) + size_t(i)];
                sums[size_t(y) * size_t(w) + size_t(x)] += std::max(v, 0.f);
                counts[size_t(y) * size_t(w) + size_t(x)] += v >= 0;
            }
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            float sum = 0, count = 0;
            const size_t at = size_t(y) * size_t(w) + size_t(x);
            for (int j = std::max(0, y - radius); j <= std::min(h - 1, y + radius); ++j)
                sum += sums[size_t(j) * size_t(w) + size_t(x)], count += counts[size_t(j) * size_t(w) + size_t(x)];
            out[at] = image.variance[at] < 0 ? -1 : std::max(image.variance[at], sum / std::max(count, 1.f));
        }
    return out;
}

}  // namespace

ThresholdFilter::ThresholdFilter(const Image& whole, float threshold, int radius) {
    if (radius < 1) return;
    const int w = whole.width, h = whole.height;
    const std::vector<float> variance = pooled(whole, radius);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
            const size_t at = size_t(y) * size_t(w) + size_t(x);
            const float value = whole.values[at], v = variance[at], off = value - threshold;
            if (v < 0 || !(off * off < ambiguous * ambiguous * v)) continue;
            const size_t first = weights_.size();
            float sum = 0;
            for (int j = std::max(0, y - radius); j <= std::min(h - 1, y + radius); ++j)
                for (int i = std::max(0, x - radius); i <= std::min(w - 1, x + radius); ++i) {
                    const size_t near = size_t(j) * size_t(w) + size_t(i);
                    const float d = whole.values[near] - value, q = d * d / (likeness * (v + variance[near]));
                    if (variance[near] < 0 || !(q < 1)) continue;
                    weights_.push_back({uint32_t(near), (1 - q) * (1 - q)});
                    sum += weights_.back().weight;
                }
            for (size_t k = first; k < weights_.size(); ++k) weights_[k].weight /= sum;
            pixels_.push_back({uint32_t(at), weights_.size()});
        }
}

void ThresholdFilter::apply(const std::vector<float>& image, std::vector<float>& out) const {
    out = image;
    size_t k = 0;
    for (const Pixel& p : pixels_) {
        float sum = 0;
        for (; k < p.end; ++k) sum += weights_[k].weight * image[weights_[k].pixel];
        out[p.pixel] = sum;
    }
}

}  // namespace uncertainty
