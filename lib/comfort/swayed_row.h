// SPDX-License-Identifier: BSD-3-Clause
// A row of swayed pictures, of which sums by word of signs are made (swayed.h), and the sums of its light.
#pragma once
#include <array>
#include <vector>
#include "comfort/geometry.h"
#include "comfort/swayed.h"

namespace comfort {

// What the pixels of a row show where the sign of their word is 1 and where it is -1: mean + sway and mean - sway.
class SwayedRow {
public:
    explicit SwayedRow(int width);
    void show(const Swayed& pictures, int row, const Span& columns);
    const float* mean() const { return mean_; }
    const float* sway() const { return sway_.data(); }
    const float* plus() const { return plus_.data(); }
    const float* minus() const { return minus_.data(); }
    const unsigned* words(int x) const { return &word_[size_t(x % Signs::words)]; }  // of column x and those behind it

private:
    const float* mean_ = nullptr;
    std::vector<float> sway_, plus_, minus_;         // and some more, which are read but do not count
    std::array<unsigned, 2 * Signs::words> word_{};  // by column
};

// What swayed pictures have more light than their mean, row by row.
// Sums over the pixels of z^2 and z^4, z how far a pixel's share of the light at the eye is off its mean.
struct OffAtEye {
    double squares = 0, fourths = 0;
};

class MoreLight {
public:
    explicit MoreLight(bool all) : all_(all) {}  // else only what comes to the eye
    void add(const SwayedRow& pictures, const Geometry& geometry, int row);
    std::array<Light, Signs::most> of_pictures(const Signs& signs) const;
    const OffAtEye& off_at_eye() const { return off_at_eye_; }

private:
    bool all_;
    std::array<Light, Signs::words> by_word_;
    OffAtEye off_at_eye_;
};

}  // namespace comfort
