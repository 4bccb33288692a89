// SPDX-License-Identifier: BSD-3-Clause
// Sums of |a - b| over neighbours in swayed pictures, without making these.  A pixel shows one of two values, so that a
// pair has four differences, by the signs s and t of the two:  A + s B + t C + s t D.  Each of the four is summed for
// itself; at the end A goes to all pictures and B, C and D to those of the words of s, t and s t (swayed.h).
#pragma once
#include <array>
#include <vector>
#include "comfort/swayed.h"

namespace comfort {

// What the pixels of a row show where the sign of their word is 1 and where it is -1: mean + sway and mean - sway.
class SwayedRow {
public:
    explicit SwayedRow(int width);
    void show(const Swayed& pictures, int row, int begin, int end);
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

class PairSums {
public:
    // n pairs: of a, from column x on, and of b, from column x + shift on.
    void add(const SwayedRow& a, const SwayedRow& b, int x, int shift, int n);
    std::array<double, Signs::most> of_pictures(const Signs& signs) const;

private:
    std::array<double, Signs::words> by_word_{};  // times 4
};

}  // namespace comfort
