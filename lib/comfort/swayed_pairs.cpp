// SPDX-License-Identifier: BSD-3-Clause
// Sixteen pairs side by side have the words of the sixteen before them (swayed_pairs.h).
#include "comfort/swayed_pairs.h"

#include <algorithm>

#include "base/wide.h"
#include "comfort/lanes.h"

namespace comfort {
namespace {

constexpr int side_by_side = Signs::words, parts = side_by_side / lanes;
constexpr int stretch = 32 * side_by_side;  // short, so that float is enough

struct Values {
    const float *plus, *minus;
};
// Of pairs side by side, times 4: the sum of the A, and by column of the B, C and D.
struct FourSums {
    double all = 0;
    float own[side_by_side], other[side_by_side], product[side_by_side];
};

// Reads up to the end of the last sixteen.
WIDE_LOOP void add_pairs(const Values& a, const Values& b, int n, FourSums& to) {
    Floats pp[parts] = {}, pm[parts] = {}, mp[parts] = {}, mm[parts] = {};
    const auto add = [&](int x, int k, const Words& wanted) __attribute__((always_inline)) {
        const Floats ap = load(a.plus + x), am = load(a.minus + x), bp = load(b.plus + x), bm = load(b.minus + x);
        pp[k] += distance(ap, bp, wanted), pm[k] += distance(ap, bm, wanted);
        mp[k] += distance(am, bp, wanted), mm[k] += distance(am, bm, wanted);
    };
    int x = 0;
    for (; x + side_by_side <= n; x += side_by_side)
        for (int k = 0; k < parts; ++k) add(x + k * lanes, k, all_lanes);
    for (int k = 0; k < parts; ++k, x += lanes) add(x, k, first_lanes(n - x));
    Floats all = {};
    for (int k = 0; k < parts; ++k) {
        const Floats same = pp[k] + mm[k], unlike = pm[k] + mp[k], turn = pp[k] - mm[k], cross = pm[k] - mp[k];
        all += same + unlike;
        store(turn + cross, to.own + k * lanes), store(turn - cross, to.other + k * lanes);
        store(same - unlike, to.product + k * lanes);
    }
    to.all = 0;
    for (int k = 0; k < lanes; ++k) to.all += double(all[k]);
}

}  // namespace

void PairSums::add(const SwayedRow& a, const SwayedRow& b, int x, int shift, int n) {
    const unsigned *v = a.words(x), *w = b.words(x + shift);
    for (int first = x; first < x + n; first += stretch) {
        FourSums sum;
        add_pairs({a.plus() + first, a.minus() + first}, {b.plus() + first + shift, b.minus() + first + shift},
                  std::min(stretch, x + n - first), sum);
        by_word_[0] += sum.all;
        for (int k = 0; k < side_by_side; ++k)
            by_word_[v[k]] += sum.own[k], by_word_[w[k]] += sum.other[k], by_word_[v[k] ^ w[k]] += sum.product[k];
    }
}

std::array<double, Signs::most> PairSums::of_pictures(const Signs& signs) const {
    std::array<double, Signs::most> out{};
    for (size_t w = 0; w < by_word_.size(); ++w)
        for (size_t k = 0; k < out.size(); ++k) out[k] += signs.factor[w][k] * by_word_[w] / 4;
    return out;
}

}  // namespace comfort
