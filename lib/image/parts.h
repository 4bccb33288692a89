// SPDX-License-Identifier: BSD-3-Clause
// A growing mean as up to sixteen sums of whole frames: the random groups of replication methods (Wolter, Introduction
// to Variance Estimation, 2007, chapter 2), from which lib/uncertainty estimates errors.
//
// The unit is a range of frames:
// whatever correlates pixels does so inside of a frame.  A range goes whole to the sum of the fewest frames.  Among
// equals in round r, where all sums hold r frames or more, it is the one of the smallest index xor r: samples are
// points of a sequence in base 2 (kernels/sampling/sampler.h), in which every sixteenth has the same first digits, and
// each sum should have all of them.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace image {

using Ranges = std::vector<std::pair<int64_t, int64_t>>;  // first and last frame, both included
using SeedRanges = std::vector<std::pair<std::optional<uint64_t>, Ranges>>;

constexpr size_t most_parts = 16;

struct Part {
    int64_t frames = 0;       // diffuse ones
    std::vector<float> grey;  // mean of L(0) + L(k) over its frames k (grey.h), row 0 = top; partial sums: without L(0)
    SeedRanges from;          // which frames these are; empty: not known
};

int64_t frames_of(const std::vector<Part>& parts);

// Adds a range to the part of the fewest frames, or as a part of its own while there are fewer than `most`.
// Returns that part's index.
size_t add_part(std::vector<Part>& parts, Part&& range, size_t most = most_parts);

// The parts of a mean that grows: each mean adds the range of frames since the one before it.
class GrowingParts {
public:
    explicit GrowingParts(size_t most = most_parts) : most_(most) {}
    void restart();
    // Goes on after a mean of n frames with these parts.
    void resume(std::vector<Part> parts, std::vector<float> mean, int64_t n);
    // L'(n) of `pixels` grey pixels.  Ignored if n is not above the mean before.
    // seed, first: of the frames, the first of which is `first`.
    void add(const float* mean, size_t pixels, int64_t n, std::optional<uint64_t> seed = {}, int64_t first = 1);
    int64_t frames() const { return frames_; }
    const std::vector<Part>& parts() const { return parts_; }

private:
    size_t most_;
    std::vector<Part> parts_;
    std::vector<float> mean_;  // the last one
    int64_t frames_ = 0;
};

// Seeds and ranges as lines of a header, "SEED=7", "RANGE=1:4"; and back.  Throws Error (where).
std::string to_text(const SeedRanges& from);
SeedRanges seed_ranges(const std::string& text, const std::string& where);

}  // namespace image
