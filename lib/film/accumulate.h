// SPDX-License-Identifier: BSD-3-Clause
// The sum of frames, paper Eq. 7:  L'(n) = L(0) + (1/n) (L(1) + ... + L(n)),  L'(0) = L(0).
// n counts diffuse frames.  Sums are exact (exact_sum.h), so that the order of frames and merges leaves no trace.
//
// A sum that began at a frame a > 0 is a partial result, (1/n) (L(a) + ... + L(b)), without frame 0.
// Merging weights the diffuse part by frame counts: with frame 0 known apart,
//     L' = L(0) + (n1 D1 + n2 D2 + ...) / (n1 + n2 + ...),  Di = L'i - L(0) or the partial result itself.
// Pictures of different seeds are independent estimates of one scene; complete ones average to
//     L' = (n1 L'1 + n2 L'2 + ...) / (n1 + n2 + ...),
// partial ones cannot: a frame k may hold a correction to the frame 0 of its own seed (paper section 7).
#pragma once
#include <cstdint>
#include <string>
#include <vector>
#include "film/exact_sum.h"
#include "film/merge_parts.h"
#include "image/picture.h"

namespace film {

// Value i of Eq. 7 for n diffuse frames; frame0 is empty for a partial result.
double eq7(const std::vector<float>& frame0, const ExactSum& sum, int64_t n, size_t i);
// Adds the diffuse frames of a sum: exactly where it has them so (Picture::sum), else its rounded mean times n.
void add_frames_of(const image::Picture& picture, const std::string& name, ExactSum& sum);

class Accumulator {
public:
    // Does this frame begin a sum of its own?  Frame 0 does, and the first one of another view, sky or action.
    bool restarts(const image::Header& frame) const;
    // The next frame of the stream (FRAME=k in its header).  Throws Error (place) for a frame missing, repeated
    // or out of order, and for another size, view, seed or fingerprint inside one sum.
    void add(const image::Picture& frame, const std::string& place);
    // Goes on from a sum made before: its frames of one seed, without holes, frame 0 known apart.  The next frame is
    // the one after its last; frame 0 does not restart it.
    void resume(const image::Picture& sum, const std::string& name);
    const image::Header& header() const { return header_; }  // of the first frame
    bool empty() const { return next_ < 0; }
    int64_t frames() const { return next_ - (first_ == 0 ? 1 : first_); }  // n, diffuse frames summed
    const image::Moments& moments() const { return moments_; }             // of frame 0 (picture.h)
    // L'(n) or the partial result; reuses the memory of out.  with_parts keeps L(0), its moments and the exact sum, too
    // (for EXR).
    void result(image::Picture& out, bool with_parts) const;

private:
    void start(const image::Picture& frame, int64_t k);
    void require_next(int64_t k, const std::string& place) const;
    void require_same(const image::Picture& frame, const std::string& place) const;
    int width_ = 0, height_ = 0;
    int64_t first_ = 0, next_ = -1;
    image::Header header_;
    std::string resumed_;  // name of the sum that this one goes on from
    bool grown_ = false;   // it has got frames since
    std::vector<float> frame0_;
    image::Moments moments_;
    ExactSum sum_;
};

class Merger {
public:
    // parts: how many to keep (merge_parts.h).
    explicit Merger(std::optional<int> parts = {}) : parts_(parts) {}
    // An accumulated picture (FRAMES=, RANGE=).  Throws Error if it does not go with those before it.
    void add(image::Picture picture, const std::string& name);
    image::Picture result() const;

private:
    struct Group {  // one seed
        bool has_seed = false;
        uint64_t seed = 0;
        int64_t frames = 0;
        image::Ranges ranges;
        ExactSum sum;               // of diffuse frames
        std::vector<float> frame0;  // empty: not there
        image::Moments moments;     // likewise
        image::Picture whole;       // complete, its frame 0 not known apart (no more of this seed can be added)
        bool is_whole() const { return !whole.rgb.empty(); }
        bool complete() const { return is_whole() || !frame0.empty(); }
        std::string last_name;
    };
    Group& group_of(const image::Header& header);
    image::Moments merged_moments() const;
    void check_ranges(const image::Header& header, const std::string& name) const;
    std::vector<Group> groups_;
    PartsMerger parts_;
    image::Header first_;
    int width_ = 0, height_ = 0, inputs_ = 0;
    std::string first_name_;
    std::vector<std::string> history_;
};

// The n at which a sum is written: every one, every N-th, or F^(i/M) rounded, i = 0, 1, 2 ... ("x2", "x2/16").
class Schedule {
public:
    static Schedule parse(const std::string& text, const std::string& where);
    void restart() { next_ = 0; }
    void resume(int64_t n) { next_ = after(n); }  // n has been written before
    bool due(int64_t n);                          // called with rising n; n = 0 is always due

private:
    int64_t after(int64_t n) const;  // the first n of the schedule above this one
    int64_t every_ = 1;
    double factor_ = 0;  // 0: every_
    int64_t parts_ = 1, next_ = 0;
};

}  // namespace film
