// SPDX-License-Identifier: BSD-3-Clause
// Less noise for people's eyes, never for numbers: dual-buffer non-local means after F. Rousselle, C. Knaus, M.
// Zwicker, "Adaptive Rendering with Non-local Means Filtering" (ACM Transactions on Graphics 31, 2012). The frames are
// summed in two halves.  Each half is averaged with weights that are found in the other one, so that the noise of a
// pixel does not decide which pixels it is averaged with; the frames' own variance says what is noise.
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace display {

// Sums of both halves of the frames 1, 2, 3 ... of a sum, for the filter.
class HalfSums {
public:
    void clear(size_t values);
    void add(const std::vector<float>& frame);
    int64_t frames() const { return frames_; }
    size_t size() const { return squares_.size(); }
    // Fewer tell nothing about their variance.
    static constexpr int64_t least_frames = 4;

private:
    friend std::vector<float> denoised(const HalfSums&, const std::vector<float>&, int, int, unsigned);
    int64_t frames_ = 0;
    std::vector<float> half_[2];  // sums of the odd frames and of the even ones
    std::vector<float> squares_;  // sum of the squares of all
};

// The picture L(0) + mean of the frames, filtered: 3 floats a pixel.
std::vector<float> denoised(const HalfSums& sums, const std::vector<float>& frame0, int width, int height,
                            unsigned threads);

}  // namespace display
