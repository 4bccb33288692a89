// SPDX-License-Identifier: BSD-3-Clause
// Signs by pattern, and what is told of pictures without making them (swayed.h).
#include "comfort/swayed.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "base/wide.h"

namespace comfort {
namespace {

constexpr int block = 32;

// The least of what the brightest of these pixels are in each picture.
WIDE_LOOP float surely_reached(const float* mean, const float* off, int n) {
    float top[block] = {};
    int i = 0;
    for (; i + block <= n; i += block)
        for (int k = 0; k < block; ++k) top[k] = std::max(top[k], mean[i + k] - std::fabs(off[i + k]));
    for (; i < n; ++i) top[0] = std::max(top[0], mean[i] - std::fabs(off[i]));
    return *std::max_element(top, top + block);
}

WIDE_LOOP bool any_exceeds(const float* mean, const float* off, int n, float limit) {
    int found = 0;
    for (int i = 0; i < n; ++i) found |= mean[i] + std::fabs(off[i]) > limit;
    return found;
}

}  // namespace

Signs::Signs(int pictures, const std::array<uint32_t, 4>& basis) : count(pictures) {
    for (unsigned p = 0; p < patterns; ++p) {
        minus[p] = p & turned ? (uint32_t(1) << pictures) - 1 : 0;
        for (unsigned b = 0; b < basis.size(); ++b)
            if (p >> b & 1) minus[p] ^= basis[b];
        for (unsigned k = 0; k < most; ++k) {
            flip[p][k] = (minus[p] >> k & 1) << 31;
            factor[p][k] = minus[p] >> k & 1 ? -1 : 1;
        }
    }
}

// Each row has every word side by side, in an order of its own; another one in place of those that are not wanted.
std::vector<uint8_t> Signs::weave(int width, int height, unsigned first_word) {
    uint64_t state = 0;
    const auto random = [&] {  // SplitMix64
        uint64_t z = state += 0x9e3779b97f4a7c15u;
        z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
        z = (z ^ z >> 27) * 0x94d049bb133111ebu;
        return z ^ z >> 31;
    };
    const auto below = [&](unsigned n) { return unsigned((random() >> 32) * n >> 32); };
    std::vector<uint8_t> out(size_t(width) * size_t(height));
    for (size_t row = 0; row < out.size(); row += size_t(width)) {
        uint8_t word[words];
        for (unsigned k = 0; k < words; ++k) {
            const unsigned other = below(k + 1);
            word[k] = word[other];
            word[other] = uint8_t(k);
        }
        for (uint8_t& w : word)
            if (w < first_word) w = uint8_t(first_word + below(words - first_word));
        uint64_t bits = 0;
        for (int x = 0; x < width; x += 8, bits >>= 8) {
            if (x % 64 == 0) bits = random();
            const int n = std::min(8, width - x);
            uint8_t eight[8];
            for (unsigned k = 0; k < 8; ++k) eight[k] = uint8_t(word[x % words + k] | (bits >> k & 1) * turned);
            std::memcpy(&out[row + size_t(x)], eight, size_t(n));
        }
    }
    return out;
}

bool Swayed::may_exceed(size_t first, int n, float limit) const {
    return any_exceeds(mean + first, off + first, n, limit);
}

void Swayed::picture(int number, GreyPicture& out) const {
    out.width = width, out.height = height;
    out.grey.resize(size_t(width) * size_t(height));
    for (size_t i = 0; i < out.grey.size(); ++i) out.grey[i] = at(number, i);
}

std::array<float, Signs::most> Swayed::brightest(const Geometry& g) const {
    float least = 0;
    const auto each_span = [&](auto visit) {
        for (int r = 0; r < height; ++r)
            for (size_t s = g.row_spans[r]; s < g.row_spans[r + 1]; ++s)
                visit(size_t(r) * width + g.spans[s].begin, g.spans[s].end - g.spans[s].begin);
    };
    each_span([&](size_t first, int n) { least = std::max(least, surely_reached(mean + first, off + first, n)); });
    std::array<float, Signs::most> out;
    out.fill(least);
    each_span([&](size_t first, int n) {
        for (int i = 0; i < n; i += block) {
            const int count = std::min(block, n - i);
            if (!may_exceed(first + i, count, least)) continue;
            for (size_t p = first + i; p < first + i + count; ++p)
                for (int k = 0; k < this->count(); ++k) out[size_t(k)] = std::max(out[size_t(k)], at(k, p));
        }
    });
    return out;
}

}  // namespace comfort
