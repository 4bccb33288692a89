// SPDX-License-Identifier: BSD-3-Clause
// Columns 16 apart have the same word (swayed_row.h).
#include "comfort/swayed_row.h"

#include <algorithm>
#include <cstring>

#include "base/wide.h"

namespace comfort {
namespace {

WIDE_LOOP void show_both(const float* mean, const float* off, const uint8_t* pattern, int n, float* __restrict sway,
                         float* __restrict plus, float* __restrict minus) {
    for (int x = 0; x < n; ++x) {
        const float sign = float(1 - 2 * int(pattern[x] / Signs::turned)), own = sign * off[x];
        sway[x] = own, plus[x] = mean[x] + own, minus[x] = mean[x] - own;
    }
}

WIDE_LOOP void add_light(const float* sway, const double* weight, int n, double* by_column) {
    double sum[Signs::words] = {};
    int i = 0;
    for (; i + Signs::words <= n; i += Signs::words)
        for (int k = 0; k < Signs::words; ++k) sum[k] += double(sway[i + k]) * weight[i + k];
    for (int k = 0; i < n; ++i, ++k) sum[k] += double(sway[i]) * weight[i];
    for (int k = 0; k < Signs::words; ++k) by_column[k] = sum[k];
}

// The weights are in the cache by now.
WIDE_LOOP OffAtEye powers(const float* sway, const double* weight, int n) {
    constexpr int many = 4;
    using Doubles = double __attribute__((vector_size(8 * many)));
    using Singles = float __attribute__((vector_size(4 * many)));
    Doubles squares = {}, fourths = {};
    const auto add = [&](int first, int count) __attribute__((always_inline)) {
        Singles off = {};
        Doubles weights = {};
        std::memcpy(&off, sway + first, sizeof(float) * size_t(count));
        std::memcpy(&weights, weight + first, sizeof(double) * size_t(count));
        const Doubles z = __builtin_convertvector(off, Doubles) * weights, square = z * z;
        squares += square, fourths += square * square;
    };
    int i = 0;
    for (; i + many <= n; i += many) add(i, many);
    if (i < n) add(i, n - i);
    OffAtEye out;
    for (int k = 0; k < many; ++k) out.squares += squares[k], out.fourths += fourths[k];
    return out;
}

}  // namespace

SwayedRow::SwayedRow(int width) {
    for (std::vector<float>* v : {&sway_, &plus_, &minus_}) v->resize(size_t(width + Signs::words));
}

void SwayedRow::show(const Swayed& s, int row, const Span& columns) {
    const size_t first = size_t(row) * size_t(s.width), at = first + size_t(columns.begin), x = size_t(columns.begin);
    for (int k = 0; k < std::min(s.width, int(Signs::words)); ++k)
        word_[size_t(k)] = word_[size_t(k + Signs::words)] = s.pattern[first + size_t(k)] % Signs::turned;
    mean_ = s.mean + first;
    show_both(s.mean + at, s.off + at, s.pattern + at, columns.end - columns.begin, &sway_[x], &plus_[x], &minus_[x]);
}

void MoreLight::add(const SwayedRow& pictures, const Geometry& g, int row) {
    for (size_t s = g.row_spans[row]; s < g.row_spans[row + 1]; ++s) {
        const int begin = g.spans[s].begin, n = g.spans[s].end - begin;
        const size_t from = size_t(row) * size_t(g.width) + size_t(begin);
        const unsigned* word = pictures.words(begin);
        double eye[Signs::words], all[Signs::words] = {};
        add_light(pictures.sway() + begin, &g.omega_cos[from], n, eye);
        const OffAtEye off = powers(pictures.sway() + begin, &g.omega_cos[from], n);
        off_at_eye_.squares += off.squares, off_at_eye_.fourths += off.fourths;
        if (all_) add_light(pictures.sway() + begin, &g.omega[from], n, all);
        for (int k = 0; k < Signs::words; ++k) by_word_[word[k]].eye += eye[k], by_word_[word[k]].all += all[k];
    }
}

std::array<Light, Signs::most> MoreLight::of_pictures(const Signs& signs) const {
    std::array<Light, Signs::most> out;
    for (size_t w = 0; w < by_word_.size(); ++w)
        for (size_t k = 0; k < out.size(); ++k) {
            out[k].eye += signs.factor[w][k] * by_word_[w].eye;
            out[k].all += signs.factor[w][k] * by_word_[w].all;
        }
    return out;
}

}  // namespace comfort
