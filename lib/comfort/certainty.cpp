// SPDX-License-Identifier: BSD-3-Clause
// Leaving out one batch after another (certainty.h).
#include "comfort/certainty.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "comfort/student.h"
#include "image/picture.h"

namespace comfort {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double growth_between_looks = 1.41421356;
constexpr int moved_pictures = 4;
constexpr int enough_batches = 6;

// A standard error below this share of the value is the rounding of floats.
constexpr double rounding = 1e-6;

// Chance that one of `count` batches has by luck the share that the worst one has in the sum of squares (Cochran's
// test): such a share s of one degree in count - 1 goes with t^2 = s/(1-s) (count - 2).
bool one_batch_dominates(double share, double degrees) {
    if (degrees < 3 || !(share < 1)) return share >= 1;
    return (degrees + 1) * student_outside(std::sqrt(share / (1 - share) * (degrees - 1)), degrees - 1) < 0.001;
}

// Has direct samples of its own: the batch lies behind frame 16, or is the first one and holds these frames together.
bool is_whole(const Batches& batches, size_t k) {
    return batches.begin(k) >= image::direct_samples || (k == 0 && batches.frames(k) >= image::direct_samples);
}

struct Spread {
    double variance = 0, degrees = 0, worst_share = 0;
};

// The variance of an estimate from its changes when batches are left out (certainty.h).
Spread spread_of(const Batches& batches, const std::vector<double>& change, bool whole_ones) {
    const double n = double(batches.frames());
    std::vector<std::pair<double, double>> off;  // weight, and how far the batch lies off
    double mean = 0, weight = 0;
    for (size_t k = 0; k < batches.count(); ++k) {
        if (whole_ones && !is_whole(batches, k)) continue;
        const double m = double(batches.frames(k));
        off.push_back({m, (n - m) / m * change[k]});
        mean += m * off.back().second, weight += m;
    }
    Spread out;
    double sum = 0, worst = 0;
    for (const auto& [m, x] : off) {
        const double square = m * std::pow(x - mean / weight, 2);
        sum += square, worst = std::max(worst, square);
    }
    out.degrees = double(off.size()) - 1;
    out.variance = sum / out.degrees / n;
    out.worst_share = sum > 0 ? worst / sum : 0;
    return out;
}

}  // namespace

bool Estimate::known() const { return error > rounding * std::fabs(value) && degrees > 0; }

double Estimate::half_width(double outside, int64_t n) const {
    return known() ? error * std::sqrt(double(frames) / double(n)) * student_quantile(outside, degrees) : nan;
}

Certainty::Certainty(Meter& meter, const std::vector<Column>& columns, bool errors)
    : meter_(meter), columns_(columns), errors_(errors) {
    restart();
}

void Certainty::restart() {
    batches_.restart();
    frame0_error_.clear();
    estimates_.assign(columns_.size(), {nan, nan, 0, false, 0});
    own_ = estimates_;
    next_look_ = 2;
    looks_ = 0;
}

void Certainty::frame0(const Luminance& lum) {
    const Geometry& g = meter_.geometry();
    const size_t w = size_t(lum.width);
    std::vector<float> squares(lum.size(), 0), blocks(lum.size(), 0);
    for (size_t i = 0; i + w + 1 < lum.size(); ++i) {
        if (i % w + 1 == w || !g.valid(i) || !g.valid(i + 1) || !g.valid(i + w) || !g.valid(i + w + 1)) continue;
        const float off = (lum.grey[i] - lum.grey[i + 1] - lum.grey[i + w] + lum.grey[i + w + 1]) / 2;
        for (const size_t p : {i, i + 1, i + w, i + w + 1}) squares[p] += off * off, blocks[p] += 1;
    }
    for (size_t i = 0; i < squares.size(); ++i) squares[i] = blocks[i] > 0 ? std::sqrt(squares[i] / blocks[i]) : 0;
    frame0_error_ = std::move(squares);
}

void Certainty::add(const Luminance& lum, int64_t n) { batches_.add(lum, n); }

Certainty::Values Certainty::values(const Measurement& m) const {
    Values out;
    for (const Column& c : columns_) {
        out.plain.push_back(c.value(m));
        out.unbiased.push_back(c.unbiased && m.unbiased ? c.unbiased(m) : nan);
    }
    return out;
}

Certainty::Values Certainty::leave_out(size_t batch, const Batches::Parts& whole, Batches::Parts& parts) {
    batches_.without(batch, scratch_);
    Luminance lum = scratch_.luminance();
    Measurement m = meter_.measure(lum, "");
    if (meter_.needs().unbiased()) {
        batches_.without(batch, whole, parts);
        meter_.extrapolate(parts, m);
    }
    return values(m);
}

void Certainty::look(Measurement& m) {
    next_look_ = int64_t(std::ceil(double(batches_.frames()) * growth_between_looks));
    ++looks_;
    Batches::Parts whole, parts;
    if (meter_.needs().unbiased()) {
        batches_.split(whole);
        meter_.extrapolate(whole, m);
    }
    const Values now = values(m);
    std::vector<Values> without;
    if (errors_)
        for (size_t k = 0; k < batches_.count(); ++k) without.push_back(leave_out(k, whole, parts));
    std::vector<Estimate> fresh;
    for (size_t c = 0; c < columns_.size(); ++c) fresh.push_back(estimate_of(c, now, without));
    if (errors_ && !whole_batches_suffice()) add_frame0_error(now, fresh);
    for (size_t c = 0; c < columns_.size(); ++c) {
        const Estimate before = own_[c];
        own_[c] = estimates_[c] = fresh[c];
        const double carried = before.error * std::sqrt(double(before.frames) / double(fresh[c].frames));
        if (carried > fresh[c].error) estimates_[c].error = carried;  // a nan is not
    }
}

bool Certainty::whole_batches_suffice() const {
    int whole = 0;
    for (size_t k = 0; k < batches_.count(); ++k) whole += is_whole(batches_, k);
    return whole >= enough_batches;
}

Estimate Certainty::estimate_of(size_t column, const Values& now, const std::vector<Values>& without) const {
    const bool unbiased = bool(columns_[column].unbiased);
    const auto value = [&](const Values& v) { return unbiased ? v.unbiased[column] : v.plain[column]; };
    Estimate out{value(now), nan, 0, false, batches_.frames()};
    if (without.size() < 2) return out;

    std::vector<double> change;
    double corrected = double(without.size()) * out.value;
    for (size_t k = 0; k < without.size(); ++k) {
        change.push_back(out.value - value(without[k]));
        corrected -= (1 - double(batches_.frames(k)) / double(batches_.frames())) * value(without[k]);
    }
    if (columns_[column].ratio) out.value = corrected;
    const Spread s = spread_of(batches_, change, whole_batches_suffice());
    out.error = std::sqrt(s.variance);
    out.degrees = s.degrees;
    out.tails = one_batch_dominates(s.worst_share, s.degrees);
    return out;
}

void Certainty::add_frame0_error(const Values& now, std::vector<Estimate>& estimates) {
    if (frame0_error_.empty()) {  // the stream did not begin with it: nothing tells its error
        for (Estimate& e : estimates) e.error = nan;
        return;
    }
    std::vector<double> square(columns_.size(), 0);
    uint32_t random = 1;
    for (int k = 0; k < moved_pictures; ++k) {
        scratch_.grey = batches_.whole();
        for (size_t i = 0; i < scratch_.grey.size(); ++i) {
            random = random * 1664525u + 1013904223u;
            scratch_.grey[i] += random & 0x80000000u ? frame0_error_[i] : -frame0_error_[i];
        }
        Luminance lum = scratch_.luminance();
        const Measurement m = meter_.measure(lum, "");
        const Values moved = values(m);
        for (size_t c = 0; c < square.size(); ++c)
            square[c] += std::pow(moved.plain[c] - now.plain[c], 2) / moved_pictures;
    }
    // From frame 17 on there are more direct samples than frame 0's.
    const double share = std::min(1., double(image::direct_samples) / double(batches_.frames()));
    for (size_t c = 0; c < square.size(); ++c) {
        Estimate& e = estimates[c];
        const double own = e.error * e.error, zero = square[c] * share, both = own + zero;
        if (zero > 0) e.degrees = both * both / (own * own / e.degrees + zero * zero / moved_pictures);
        e.error = std::sqrt(both);
    }
}

}  // namespace comfort
