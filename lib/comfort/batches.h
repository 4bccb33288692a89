// SPDX-License-Identifier: BSD-3-Clause
// A growing mean cut into batches of frames, from which its error can be told.
// What is kept are the means at the batches' ends (image/means.h), at most 17 grey pictures.  Beyond 16 batches those
// two neighbours are joined that hold the fewest frames together.
// What is told of a batch may be slightly negative in places.
#pragma once
#include <cstdint>
#include <vector>
#include "comfort/luminance.h"
#include "image/means.h"

namespace comfort {

// A grey picture of its own.
struct GreyPicture {
    int width = 0, height = 0;
    std::vector<float> grey;
    Luminance luminance();  // borrows `grey`
};

class Batches {
public:
    void restart() { ends_.clear(); }
    // L'(n), n rising and above 0.  Not copied if it stands in room(), where it stays until the next one.
    void add(const Luminance& mean, int64_t n);
    std::vector<float>& room() { return spare_; }

    size_t count() const { return ends_.size(); }
    int width() const { return width_; }
    int height() const { return height_; }
    int64_t frames() const { return ends_.empty() ? 0 : ends_.back().frames; }
    int64_t frames(size_t batch) const { return ends_[batch].frames - begin(batch); }
    int64_t begin(size_t batch) const { return batch ? ends_[batch - 1].frames : 0; }  // frames before it

    const std::vector<float>& whole() const { return ends_.back().grey; }  // L'(n)
    // The mean of all frames but those of a batch, of these pixels; the others are left as they are.
    void without(size_t batch, const std::vector<uint32_t>& pixels, GreyPicture& out) const;

    const std::vector<float>& mean_at(size_t batch) const { return ends_[batch].grey; }  // L' at the batch's end

    // Two halves of the frames, by batch: those up to the end that lies nearest to half of all, or, as long as each
    // frame is a batch, those whose halves of frame 0's samples differ (image/picture.h).
    struct Split {
        std::vector<bool> first;
        bool knows_frame0;  // they have other direct samples
    };
    Split halves() const;

private:
    int width_ = 0, height_ = 0;
    std::vector<image::GreyMean> ends_;
    std::vector<float> spare_;
};

}  // namespace comfort
