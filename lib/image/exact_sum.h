// SPDX-License-Identifier: BSD-3-Clause
// Sums without rounding, so that parts of a picture merge to the same bits in any order and grouping.
// A sum is a whole number of 2^-149, the smallest float, written in digits of 32 bits.  Digit k counts 2^(32 k - 149);
// ten digits hold 2^32 of the largest floats, and those that no value has touched take no memory.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>
#include "base/span.h"

namespace image {

namespace exact {
struct Exponents;
}

// The k-th digit of all sums, two's complement: the highest layer has the sign.
struct SumLayer {
    int digit = 0;
    std::vector<uint32_t> words;
};

class ExactSum {
public:
    static constexpr int digits = 10;
    static constexpr size_t share = 4096;  // sums that a thread takes at a time

    void clear(size_t count);
    size_t size() const { return count_; }
    // One value for each sum.  Those that are not finite, or reach 2^164, count as 0; below 2^-149 a double is cut.
    bool add(const std::vector<float>& values);  // false: there was such a value
    // Several at once, which costs the lanes' way through memory only once; `all` has the exponents of all of them.
    void add(base::Span<std::vector<float>> frames, const exact::Exponents& all, unsigned threads);
    void add(const std::vector<double>& values);
    // Those that layers() gave.  Throws Error (place) for layers that are no sum.
    void add(const std::vector<SumLayer>& layers, const std::string& place);

    // Sum i as a double: within 2^-53 of it, and a function of its value alone.
    double value(size_t i) const;
    void values(size_t first, size_t count, double* out) const;
    // As few as hold all sums, from the lowest digit up, without gaps; the same for the same sums.
    std::vector<SumLayer> layers() const;

private:
    using Number = std::array<uint32_t, digits + 1>;
    Number number(size_t i) const;
    void add_block(const float* const* frames, size_t frame_count, size_t first, size_t count);
    void add_one(float value, size_t i);
    void reach(int first, int last);  // makes these digits
    void about_to_add();
    void carry();
    size_t count_ = 0;
    uint32_t added_ = 0;                             // values since the last carry(): a lane has room for 2^29 of them
    int lowest_ = digits, end_ = 0;                  // digits that values have touched, and those between them
    std::array<std::vector<int64_t>, digits> lane_;  // not yet carried
};

}  // namespace image
