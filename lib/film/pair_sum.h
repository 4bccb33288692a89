// SPDX-License-Identifier: BSD-3-Clause
// Sums of floats as pairs of doubles, exact as long as no bit of a value is some hundred places from another's: the
// second double has what the first one rounds off (Knuth, The Art of Computer Programming 2, 4.2.2, theorem B).
#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

namespace film {

constexpr size_t numbers_a_share = 1u << 16;  // of a sum, that a thread takes at a time

class PairSum {
public:
    explicit PairSum(size_t count) : high_(count), low_(count) {}
    // One value for each sum; those that are not finite count as 0, `finite` says whether there were none.  false: the
    // sums would not be exact, and nothing was added.
    bool add(const std::vector<float>& values, unsigned threads, bool& finite);
    // Sums from i on: the nearest doubles, and what these lack.  false: they lack nothing.
    bool values(size_t i, size_t count, double* nearest, double* rest) const;

    size_t size() const { return high_.size(); }
    struct Extent {  // of absolute values above 0
        uint32_t least = UINT32_MAX, most = 0;
        bool finite = true;
    };

private:
    static bool holds(const Extent& values, int64_t n);
    std::vector<double> high_, low_;
    Extent extent_;
    int64_t added_ = 0;
};

}  // namespace film
