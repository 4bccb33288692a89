// SPDX-License-Identifier: BSD-3-Clause
// A filtered image that decides which pixels are above a threshold, while noise might decide it.
// A pixel is ambiguous if the threshold lies within 2.5 standard errors of it.  It is replaced by the mean of those
// pixels around it that differ from it by no more than noise explains: weight (1 - q)^2, q = difference^2 / (8 (v +
// v')), v the variances of both means (a sigma filter: Lee, Computer Vision, Graphics and Image Processing 24, 1983,
// with Tukey's weights).
//
// The weights are fixed by the whole mean and applied as the same linear combination to each replicate, so that the
// filtered value varies among replicates as frames make it vary.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace uncertainty {

class ThresholdFilter {
public:
    struct Image {
        int width, height;
        const float* values;    // row after row
        const float* variance;  // of each value; negative: the pixel does not count
    };
    static constexpr int largest_radius = 2;  // pixels

    ThresholdFilter() = default;  // replaces nothing
    // radius: of the neighbourhood, in pixels; 0: nothing is replaced.
    ThresholdFilter(const Image& whole, float threshold, int radius);
    bool empty() const { return pixels_.empty(); }
    size_t replaced() const { return pixels_.size(); }
    // A copy of `image`, of the same size, with ambiguous pixels replaced.
    void apply(const std::vector<float>& image, std::vector<float>& out) const;

private:
    struct Weight {
        uint32_t pixel;
        float weight;
    };
    struct Pixel {
        uint32_t pixel;
        size_t end;  // of its weights
    };
    std::vector<Pixel> pixels_;
    std::vector<Weight> weights_;
};

}  // namespace uncertainty
