// SPDX-License-Identifier: BSD-3-Clause
// A growing mean cut into batches of frames, from which its error can be told.
// What is kept are the means at the batches' ends (image/means.h), of the pixels that have been asked for.  Beyond 16
// batches those two neighbours are joined that hold the fewest frames together.  Whole pictures are kept where half the
// frames of a look to come will be, three or four of them: memory that is new, or that has left the cache, takes longer
// than what is done with it.
// What is told of a batch may be slightly negative in places.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>
#include "comfort/luminance.h"
#include "image/means.h"
#include "image/picture.h"

namespace comfort {

// A grey picture of its own.
struct GreyPicture {
    int width = 0, height = 0;
    std::vector<float> grey;
    Luminance luminance();  // borrows `grey`
};

class Batches {
public:
    void restart();
    void watch(std::vector<uint32_t> pixels) { watched_ = std::move(pixels); }  // before the first add()
    // L'(n), n rising and above 0.  Not copied if it stands in room_for_next(), where it stays until the next one:
    // there whole() is gone if nothing needs it beside that. next_look: the next time that halves are asked for, or the
    // first mean after it; last: likewise, if it is known.
    void add(const Luminance& mean, int64_t n, int64_t next_look, std::optional<int64_t> last = {});
    static int64_t look_after(int64_t n);  // the one that follows a look at n
    std::vector<float>& room_for_next();
    std::vector<float>& room();                  // of a picture
    void release(std::vector<float>&& picture);  // memory for later ones

    size_t count() const { return ends_.size(); }
    int width() const { return width_; }
    int height() const { return height_; }
    int64_t frames() const { return ends_.empty() ? 0 : ends_.back().frames; }
    int64_t frames(size_t batch) const { return ends_[batch].frames - begin(batch); }
    int64_t begin(size_t batch) const { return batch ? ends_[batch - 1].frames : 0; }  // frames before it

    const std::vector<float>& whole() const { return whole_; }  // L'(n)
    // The mean of all frames but those of a batch, of the watched pixels; the others are left as they are.
    void without(size_t batch, GreyPicture& out) const;

    // How far two halves of the frames lie apart: with x the mean of the a frames in one, y of the b in the other,
    // d = sqrt(a b)/(a + b) (x - y).  The first half ends at the mean that lies nearest to half of all, or, as long as
    // each frame is a batch, halves are those whose halves of frame 0's samples differ (image/picture.h).
    struct Distance {
        float factor;
        const float *of, *from;  // d = factor (of - from), of pixels; or factor of
        bool know_frame0;        // the halves have other direct samples
        void find(size_t first, size_t n, float* d) const;
    };
    Distance halves() const;
    bool halves_will_know_frame0() const { return !middle_.empty() && middle_.front().frames >= image::direct_samples; }

private:
    bool alternate() const;
    void follow_alternate(const std::vector<float>& before, int64_t n);
    bool may_be_half(int64_t n, int64_t step, int64_t next_look, std::optional<int64_t> last) const;
    int width_ = 0, height_ = 0;
    std::vector<image::GreyMean> ends_;  // of the watched pixels
    std::vector<uint32_t> watched_;
    std::vector<float> whole_;
    std::vector<image::GreyMean> middle_;  // that may stand at half the frames of a look
    bool whole_is_middle_ = false;
    std::vector<float> alternate_;  // as long as each frame is a batch: frames of one half less L', summed
    std::vector<float> spare_;
    std::vector<std::vector<float>> unused_;  // memory
};

}  // namespace comfort
