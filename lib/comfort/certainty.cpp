// SPDX-License-Identifier: BSD-3-Clause
// Looks: half pictures for the columns of the whole picture, batches for those of regions (certainty.h).
#include "comfort/certainty.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "comfort/pyramid.h"
#include "comfort/student.h"
#include "comfort/swayed_measure.h"
#include "image/picture.h"

namespace comfort {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr int moved_pictures = 4;
constexpr int enough_batches = 6;

// Noise that is most of a contrast goes on as sqrt 2 from half the frames to all of them, not as r says: what is left
// is up to four fifths of what is taken off at 4 frames, where Column::doubt_of_bias is that of a hundred.
double doubt_of_bias(const Column& column, int64_t frames) {
    return column.doubt_of_bias * (1 + 5 / std::sqrt(double(frames)));
}

// Chance that one of `degrees` + 1 terms has by luck the share that the largest one has in the sum of squares
// (Cochran's test): such a share s goes with t^2 = s/(1-s) (degrees - 1).
bool one_dominates(double share, double degrees) {
    if (degrees < 3 || !(share < 1)) return share >= 1;
    return (degrees + 1) * student_outside(std::sqrt(share / (1 - share) * (degrees - 1)), degrees - 1) < 0.001;
}

// Has direct samples of its own: the batch lies behind frame 8, or is the first one and holds these frames together.
bool is_whole(const Batches& batches, size_t k) {
    return batches.begin(k) >= image::direct_samples || (k == 0 && batches.frames(k) >= image::direct_samples);
}

// Error, skewness and heavy tails of an estimate from its changes when batches are left out (certainty.h).
void spread_of(const Batches& batches, const std::vector<double>& change, bool whole_ones, Estimate& out) {
    const double n = double(batches.frames());
    std::vector<std::pair<double, double>> off;  // weight, and how far the batch lies off
    double mean = 0, weight = 0;
    for (size_t k = 0; k < batches.count(); ++k) {
        if (whole_ones && !is_whole(batches, k)) continue;
        const double m = double(batches.frames(k));
        off.push_back({m, (n - m) / m * change[k]});
        mean += m * off.back().second, weight += m;
    }
    double squares = 0, cubes = 0, worst = 0;
    for (const auto& [m, x] : off) {
        const double d = x - mean / weight;
        squares += m * d * d, cubes += std::pow(m * d, 3), worst = std::max(worst, m * d * d);
    }
    const double count = double(off.size());
    const double variance = squares / (count - 1) / weight;  // with as many frames as these batches hold
    out.degrees = count - 1;
    out.error = std::sqrt(variance * weight / n);
    out.tails = one_dominates(squares > 0 ? worst / squares : 0, out.degrees);
    if (count < enough_batches || !(variance > 0)) return;
    const double third = cubes / std::pow(weight, 3) * count * count / ((count - 1) * (count - 2));
    out.skewness = third / std::pow(variance, 1.5) * std::sqrt(weight / n);
}

}  // namespace

Certainty::Certainty(Meter& meter, const std::vector<Column>& columns, bool errors)
    : meter_(meter), columns_(columns), errors_(errors), moved_signs_(moved_pictures, {1, 2, 4, 8}) {
    restart();
}

void Certainty::restart() {
    batches_.restart();
    frame0_.clear(), frame0_error_.clear();
    own_.clear();
    estimates_.assign(columns_.size(), {nan, nan, 0, 0, false, 0});
    next_look_ = 2;
    looks_ = 0;
}

void Certainty::frame0(const Luminance& lum) {
    std::vector<float>& room = batches_.room();
    frame0_error_.clear();
    if (lum.grey == room.data()) frame0_ = std::move(room);
    else frame0_.assign(lum.grey, lum.grey + lum.size());
    room.clear();
}

// Of each 2 x 2 pixels that count, how far they are off a plane, squared: the mean of those that a pixel belongs to.
void Certainty::find_frame0_error() {
    const Geometry& g = meter_.geometry();
    const size_t w = size_t(g.width), size = frame0_.size();
    // They stand w + 1 places behind the first of their pixels, so that those of a pixel's four blocks are found
    // without a look at the picture's edges.
    std::vector<float> squares(size + 2 * (w + 1), 0), blocks(squares.size(), 0);
    Level rows{g.width, g.height, g.spans, g.row_spans};
    for (int r = 0; r + 1 < g.height; ++r)
        rows.pairs(r, r + 1, 0, [&](int begin, int end) {
            const float *a = frame0_.data() + size_t(r) * w, *b = a + w;
            const size_t at = w + 1 + size_t(r) * w;
            for (int x = begin; x + 1 < end; ++x) {
                const float d = (a[x] - a[x + 1] - b[x] + b[x + 1]) / 2;
                squares[at + size_t(x)] = d * d, blocks[at + size_t(x)] = 1;
            }
        });
    frame0_error_.resize(size);
    for (size_t i = 0; i < size; ++i) {
        const auto around = [&](const std::vector<float>& v) { return ((v[i] + v[i + 1]) + v[i + w]) + v[i + w + 1]; };
        const float count = around(blocks);
        frame0_error_[i] = std::sqrt(around(squares) / std::max(count, 1.f));
    }
}

void Certainty::add(const Luminance& lum, int64_t n, std::optional<int64_t> last) {
    if (batches_.count() == 0 && errors_ && has(Kind::region)) batches_.watch(meter_.pixels_of_regions());
    batches_.add(lum, n, next_look_, last);
}

bool Certainty::has(Kind kind) const {
    return std::any_of(columns_.begin(), columns_.end(),
                       [&](const Column& c) { return c.regional == (kind == Kind::region); });
}

Certainty::Values Certainty::values(const Measurement& m, Kind kind) const {
    Values out;
    for (const Column& c : columns_) out.push_back(c.regional == (kind == Kind::region) ? c.value(m) : nan);
    return out;
}

void Certainty::pass_look() {
    next_look_ = Batches::look_after(batches_.frames());
    ++looks_;
}

void Certainty::look(const Luminance& lum, const Measurement& m) {
    pass_look();
    std::vector<Estimate> fresh(columns_.size(), {nan, nan, 0, 0, false, batches_.frames()});
    const Measurement unmoved = has(Kind::picture) ? look_at_halves(lum, m, fresh) : m;
    if (has(Kind::region)) look_at_batches(m, fresh);
    if (errors_) add_frame0_error(lum, m, unmoved, fresh);

    while (!own_.empty() && 2 * own_.front()[0].frames < batches_.frames()) own_.pop_front();
    own_.push_back(fresh);
    for (size_t c = 0; c < columns_.size(); ++c) {
        estimates_[c] = fresh[c];
        for (const std::vector<Estimate>& before : own_) {
            const Estimate& e = before[c];
            constexpr double any = 0.05;
            if (!(e.half_width(any, fresh[c].frames) > estimates_[c].half_width(any, fresh[c].frames))) continue;
            const double shrink = std::sqrt(double(e.frames) / double(fresh[c].frames));
            estimates_[c].error = e.error * shrink, estimates_[c].skewness = e.skewness * shrink;
            estimates_[c].degrees = e.degrees;
        }
    }
}

// Returns what the whole picture measures with the sources of its calm one.
Measurement Certainty::look_at_halves(const Luminance& lum, const Measurement& m, std::vector<Estimate>& estimates) {
    if (!halves_.begin(batches_, std::move(batches_.room()))) return m;  // where the next mean will stand
    const Swayed pictures = halves_.pictures();
    calm_.begin(meter_.geometry(), m.threshold);
    SwayedMeasurements seen = measure(pictures, Calmed(pictures, calm_.replaced()), lum, m, meter_, [&](int row) {
        halves_.find_row(row);
        if (meter_.needs().sources) calm_.take_row(halves_, meter_.geometry(), row);
    });
    batches_.release(halves_.give_back());
    const Values value = values(seen.calm, Kind::picture);
    std::vector<double> of_column(columns_.size() * Halves::count), undecided(of_column);
    Values of_whole(columns_.size(), 0);
    for (size_t k = 0; k < size_t(Halves::count); ++k) {
        const Values v = values(seen.own[k], Kind::picture);
        const Values w = seen.of_mean.empty() ? value : values(seen.of_mean[k], Kind::picture);
        for (size_t c = 0; c < v.size(); ++c) {
            of_column[c * Halves::count + k] = v[c];
            undecided[c * Halves::count + k] = v[c] - w[c];
            of_whole[c] += w[c] / Halves::count;
        }
    }
    for (size_t c = 0; c < columns_.size(); ++c) {
        const Column& column = columns_[c];
        if (column.regional) continue;
        Estimate& e = estimates[c];
        const double *halves = &of_column[c * Halves::count], r = column.bias_of_halves;
        e.value = column.value(m);
        if (r > 0) {  // what the mean measures with its own sources, or with those of each picture: calm.h
            const double decided = calm_.in_the_middle() ? of_whole[c] : value[c];
            e.value = decided + Halves::without_bias(of_whole[c], halves, r) - of_whole[c];
        }
        if (!errors_) continue;
        const Halves::Variance v = Halves::variance(halves);
        const double taken_off = e.value - column.value(m);
        e.error = std::sqrt(v.sum + std::pow(doubt_of_bias(column, batches_.frames()) * taken_off, 2));
        e.degrees = Halves::degrees(seen.off_at_eye);
        // A pixel at the threshold of sources may be most of the error, too, but that is no matter of its samples.
        const Halves::Variance of_samples = Halves::variance(&undecided[c * Halves::count]);
        e.tails = one_dominates(of_samples.sum > 0 ? of_samples.largest / of_samples.sum : 0, Halves::sums);
    }
    return std::move(seen.calm);
}

void Certainty::look_at_batches(const Measurement& m, std::vector<Estimate>& estimates) {
    const Values now = values(m, Kind::region);
    std::vector<Values> without;
    for (size_t k = 0; errors_ && k < batches_.count(); ++k) {
        batches_.without(k, scratch_);
        without.push_back(values(meter_.measure_regions(scratch_.luminance()), Kind::region));
    }
    for (size_t c = 0; c < columns_.size(); ++c) {
        if (!columns_[c].regional) continue;
        Estimate& e = estimates[c];
        e.value = now[c];
        if (without.size() < 2) continue;

        std::vector<double> change;
        double corrected = double(without.size()) * now[c];
        for (size_t k = 0; k < without.size(); ++k) {
            change.push_back(now[c] - without[k][c]);
            corrected -= (1 - double(batches_.frames(k)) / double(batches_.frames())) * without[k][c];
        }
        if (columns_[c].ratio) e.value = corrected;
        spread_of(batches_, change, whole_batches_suffice(), e);
    }
}

bool Certainty::whole_batches_suffice() const {
    int whole = 0;
    for (size_t k = 0; k < batches_.count(); ++k) whole += is_whole(batches_, k);
    return whole >= enough_batches;
}

// The whole picture with each pixel moved by frame 0's error, up or down at random.
std::vector<Measurement> Certainty::moved(const Luminance& lum, const Measurement& m) {
    if (frame0_error_.empty()) find_frame0_error();
    if (moved_pattern_.size() != lum.size()) moved_pattern_ = Signs::weave(batches_.width(), batches_.height(), 0);
    const Swayed pictures{batches_.width(),     batches_.height(),     batches_.whole().data(),
                          frame0_error_.data(), moved_pattern_.data(), &moved_signs_};
    std::vector<Measurement> out(moved_pictures, m);
    if (!halves_.know_frame0() && has(Kind::picture)) {
        std::vector<Doubtful> all;  // where calm pixels are sources, all of them move
        for (size_t p = 0; p < lum.size() && meter_.needs().sources; ++p)
            all.push_back({uint32_t(p), batches_.whole()[p], frame0_error_[p]});
        for (const Doubtful& d : calm_.replaced()) all[d.pixel].mean = d.mean;
        out = measure(pictures, Calmed(pictures, all), lum, m, meter_).own;
    }
    if (has(Kind::region)) add_regions(pictures, meter_, out);
    return out;
}

// For columns whose halves or batches do not know it.
void Certainty::add_frame0_error(const Luminance& lum, const Measurement& m, const Measurement& unmoved,
                                 std::vector<Estimate>& estimates) {
    const bool in_halves = !has(Kind::picture) || halves_.know_frame0();
    const bool in_batches = !has(Kind::region) || whole_batches_suffice();
    if (in_halves && in_batches) {  // and so it stays, if half pictures to come know it, too
        if (batches_.halves_will_know_frame0()) batches_.release(std::exchange(frame0_, {}));
        return;
    }
    const auto knows_it = [&](size_t c) { return columns_[c].regional ? in_batches : in_halves; };
    if (frame0_.empty()) {  // the stream did not begin with it: nothing tells its error
        for (size_t c = 0; c < columns_.size(); ++c)
            if (!knows_it(c)) estimates[c].error = nan;
        return;
    }
    std::vector<double> square(columns_.size(), 0);
    for (const Measurement& seen : moved(lum, m))
        for (size_t c = 0; c < square.size(); ++c)
            square[c] += std::pow(columns_[c].value(seen) - columns_[c].value(unmoved), 2) / moved_pictures;
    // Above frame 8 there are more direct samples than frame 0 holds.
    const double share = std::min(1., double(image::direct_samples) / double(batches_.frames()));
    for (size_t c = 0; c < square.size(); ++c) {
        if (knows_it(c)) continue;
        Estimate& e = estimates[c];
        const double own = e.error * e.error, zero = square[c] * share, both = own + zero;
        if (zero > 0) e.degrees = both * both / (own * own / e.degrees + zero * zero / moved_pictures);
        if (both > 0) e.skewness *= std::pow(own / both, 1.5);
        e.error = std::sqrt(both);
    }
}

}  // namespace comfort
