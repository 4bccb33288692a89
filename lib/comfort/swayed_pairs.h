// SPDX-License-Identifier: BSD-3-Clause
// Sums of |a - b| over neighbours in swayed pictures, without making these.  A pixel shows one of two values, so that a
// pair has four differences, by the signs s and t of the two:  A + s B + t C + s t D.  Each of the four is summed for
// itself; at the end A goes to all pictures and B, C and D to those of the words of s, t and s t (swayed.h).
#pragma once
#include <array>
#include "comfort/swayed_row.h"

namespace comfort {

class PairSums {
public:
    // n pairs: of a, from column x on, and of b, from column x + shift on.
    void add(const SwayedRow& a, const SwayedRow& b, int x, int shift, int n);
    std::array<double, Signs::most> of_pictures(const Signs& signs) const;

private:
    std::array<double, Signs::words> by_word_{};  // times 4
};

}  // namespace comfort
