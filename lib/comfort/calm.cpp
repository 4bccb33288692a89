// SPDX-License-Identifier: BSD-3-Clause
// Means of like neighbours for pixels in doubt (calm.h).
#include "comfort/calm.h"

#include <algorithm>
#include <cmath>

#include "base/wide.h"
#include "comfort/lanes.h"
#include "comfort/luminance.h"

namespace comfort {
namespace {

constexpr float doubt = 2.5f;  // standard errors from the threshold
constexpr float likeness = 8;  // q = 1 at sqrt 8 standard errors of the difference
constexpr uint32_t how_far_of = 8;
constexpr int most_radius = CalmRows::radius, rows = CalmRows::count;
constexpr int kept_rows = 8;  // of variances: at least `rows`

// How far a pixel is swayed, in standard errors of its mean: the middles of eight equally likely parts, by which it
// crosses a threshold z of them off with probability 4 F (1 - F), F the normal distribution up to z.  A step s that
// half of the pictures show counts s^2/4, so that it counts F (1 - F) s^2 on average: the variance of what noise
// decides.
constexpr float how_far[how_far_of] = {.319f, .573f, .771f, .957f, 1.150f, 1.370f, 1.652f, 2.145f};

constexpr float unsure = 2;           // standard errors: the truth of 95 % of all pixels lies no farther off
constexpr size_t few = 8;             // steps whose mean square is no measure of what the largest may do
constexpr size_t fewest = 2;          // whose middle is at most one step from either end
constexpr float well_across = 1.25f;  // thresholds of half pictures are not quite the same

// Pixels to each side of the neighbourhood, which shall not be wider than evalglare's search radius by default.
int radius_of(const Geometry& geometry) {
    constexpr double widest_rad = 0.1;
    const double pitch = std::sqrt(geometry.omega_sum / double(std::max(1L, geometry.valid_count)));
    return std::min(most_radius, int(widest_rad / (2 * pitch)));
}

// Means of 2 radius + 1 values side by side: those away from the ends.
template <int radius>
inline __attribute__((always_inline)) void inner_means(const float* from, int n, float* to) {
    for (int x = radius; x < n - radius; ++x) {
        float sum = 0;
        for (int k = -radius; k <= radius; ++k) sum += from[x + k];
        to[x] = sum * (1 / float(2 * radius + 1));
    }
}

// Squares, and their means side by side, of fewer at the ends.
WIDE_LOOP void square_row(const float* off, int radius, int n, float* squares, float* means) {
    for (int x = 0; x < n; ++x) squares[x] = off[x] * off[x];
    const auto at_an_end = [&](int x) {
        const int first = std::max(0, x - radius), last = std::min(n - 1, x + radius);
        float sum = 0;
        for (int k = first; k <= last; ++k) sum += squares[k];
        means[x] = sum / float(last - first + 1);
    };
    for (int x = 0; x < std::min(radius, n); ++x) at_an_end(x);
    for (int x = std::max(radius, n - radius); x < n; ++x) at_an_end(x);
    if (radius == 0) inner_means<0>(squares, n, means);
    else if (radius == 1) inner_means<1>(squares, n, means);
    else inner_means<most_radius>(squares, n, means);
}

// To the mean of what five rows hold, of which some may be rows of zeros.
WIDE_LOOP void raise_to_mean(const float* const* row, float share, int n, float* values) {
    const float *a = row[0], *b = row[1], *c = row[2], *d = row[3], *e = row[4];
    for (int x = 0; x < n; ++x) {
        const float mean = ((((a[x] + b[x]) + c[x]) + d[x]) + e[x]) * share;
        values[x] = std::max(values[x], mean);
    }
}

// Where noise may have carried a pixel over the threshold or below it: bits of 32 pixels a word.
WIDE_LOOP void find_doubtful(const float* grey, const float* variance, int n, float threshold, uint32_t* words) {
    const auto in_doubt = [&](const Floats& value, const Floats& its_variance) __attribute__((always_inline)) {
        const Floats off = value - threshold;
        return ~Words(off * off > doubt * doubt * its_variance);
    };
    for (; n >= in_a_word; n -= in_a_word, grey += in_a_word, variance += in_a_word)
        *words++ = which([&](int k) { return in_doubt(load(grey + k), load(variance + k)); });
    if (n == 0) return;
    float few[in_a_word] = {}, their_variance[in_a_word];
    std::fill_n(their_variance, in_a_word, -1.f);
    std::copy_n(grey, n, few), std::copy_n(variance, n, their_variance);
    *words = which([&](int k) { return in_doubt(load(few + k), load(their_variance + k)); });
}

inline __attribute__((always_inline)) float total(const Floats& v) {
    return ((v[0] + v[1]) + (v[2] + v[3])) + ((v[4] + v[5]) + (v[6] + v[7]));
}

struct Mean {
    float value, error;
};
// Around column x, a row at a time.  Reads up to lanes - radius columns from there on.
static_assert(CalmRows::count <= lanes);
WIDE_LOOP Mean average(const CalmRows& from, int x, int radius) {
    const Floats none = {};
    const Words wanted = first_lanes(2 * radius + 1);
    constexpr float no_division_by_zero = 1e-30f;
    const float own = from.grey[most_radius][x];
    const float variance = std::max(from.variance[most_radius][x], no_division_by_zero);
    Floats weights = {}, sum = {}, errors = {};
    for (int r = most_radius - radius; r <= most_radius + radius; ++r) {
        const Floats other = load(from.grey[r] + x - radius), its = load(from.variance[r] + x - radius);
        const Floats d = other - own, square = d * d;
        const Floats left = at_least(likeness * (variance + its) - square, none), share = left / (left + square);
        const Floats weight = Floats(Words(share * share) & Words(its >= none) & wanted);
        weights += weight, sum += weight * other, errors += weight * weight * its;
    }
    const float weight = total(weights);
    return {total(sum) / weight, std::sqrt(total(errors)) / weight};
}

}  // namespace

void Calm::begin(const Geometry& geometry, double threshold_cdm2) {
    radius_ = radius_of(geometry);
    threshold_ = grey_limit(threshold_cdm2);
    replaced_.clear();
    at_threshold_.clear();
    variance_.resize(size_t(kept_rows * geometry.width));
    row_means_.resize(size_t(rows * geometry.width));
    zeros_.resize(size_t(geometry.width));
    outside_.resize(size_t(geometry.width), -1.f);
    doubtful_.resize(size_t(geometry.width / in_a_word + 1));
    random_ = 1;
}

// Variances need the rows of their neighbourhood, and calm pixels the variances of theirs.
void Calm::take_row(const Halves& halves, const Geometry& geometry, int y) {
    const int w = geometry.width, last = geometry.height - 1;
    square_row(&halves.off()[size_t(y) * size_t(w)], radius_, w, variance(geometry, y), row_means(geometry, y));
    for (int at = y; at <= (y < last ? y : last + 2 * radius_); ++at) {
        const int behind = at - radius_;
        if (behind >= 0 && behind <= last) find_variance(geometry, behind);
        if (behind >= radius_) calm_row(halves.whole(), geometry, behind - radius_);
        if (behind == last + radius_ && at_threshold_.size() <= few) carry_across();
    }
}

bool Calm::in_the_middle() const { return at_threshold_.size() <= fewest; }

void Calm::carry_across() {
    for (const size_t k : at_threshold_) {
        Doubtful& d = replaced_[k];
        d.sway = std::max(d.sway, well_across * std::fabs(d.mean - threshold_));
    }
}

float* Calm::variance(const Geometry& geometry, int y) { return &variance_[size_t(y % kept_rows) * geometry.width]; }
float* Calm::row_means(const Geometry& geometry, int y) { return &row_means_[size_t(y % rows) * geometry.width]; }

// The half's own, or the mean of the neighbourhood if that is larger; -1 where a pixel does not count.
void Calm::find_variance(const Geometry& geometry, int y) {
    const int w = geometry.width;
    const int first = std::max(0, y - radius_), last = std::min(geometry.height - 1, y + radius_);
    const float* near[rows];
    for (int k = 0; k < rows; ++k) near[k] = first + k <= last ? row_means(geometry, first + k) : zeros_.data();
    float* v = variance(geometry, y);
    raise_to_mean(near, 1 / float(last - first + 1), w, v);
    int x = 0;
    for (size_t s = geometry.row_spans[y]; s < geometry.row_spans[y + 1]; x = geometry.spans[s++].end)
        std::fill(v + x, v + geometry.spans[s].begin, -1.f);
    std::fill(v + x, v + w, -1.f);
}

void Calm::calm_row(const std::vector<float>& noisy, const Geometry& geometry, int y) {
    CalmRows near;
    for (int r = 0; r < rows; ++r) {
        const int row = y + r - most_radius;
        const bool inside = row >= 0 && row < geometry.height;
        near.grey[r] = inside ? &noisy[size_t(row) * size_t(geometry.width)] : zeros_.data();
        near.variance[r] = inside ? variance(geometry, row) : outside_.data();
    }
    for (size_t s = geometry.row_spans[y]; s < geometry.row_spans[y + 1]; ++s) {
        const Span& span = geometry.spans[s];
        find_doubtful(near.grey[most_radius] + span.begin, near.variance[most_radius] + span.begin,
                      span.end - span.begin, threshold_, doubtful_.data());
        const uint32_t* bits = doubtful_.data();
        for (int x = span.begin; x < span.end; x += in_a_word, ++bits)
            for (uint32_t rest = *bits; rest; rest &= rest - 1)
                average_around(near, geometry, x + __builtin_ctz(rest), y);
    }
}

void Calm::average_around(const CalmRows& near, const Geometry& geometry, int x, int y) {
    const int begin = x - radius_, end = begin + lanes;
    Mean mean;
    if (begin >= 0 && end <= geometry.width) {
        mean = average(near, x, radius_);
    } else {
        float grey[rows][lanes], variance[rows][lanes];
        CalmRows moved;
        const int first = std::max(0, begin), n = std::min(geometry.width, end) - first;
        for (int r = 0; r < rows; ++r) {
            std::fill_n(grey[r], lanes, 0.f);
            std::fill_n(variance[r], lanes, -1.f);
            std::copy_n(near.grey[r] + first, n, grey[r] + first - begin);
            std::copy_n(near.variance[r] + first, n, variance[r] + first - begin);
            moved.grey[r] = grey[r], moved.variance[r] = variance[r];
        }
        mean = average(moved, radius_, radius_);
    }
    if (std::fabs(mean.value - threshold_) < unsure * mean.error) at_threshold_.push_back(replaced_.size());
    random_ = random_ * 1664525u + 1013904223u;
    replaced_.push_back(
        {uint32_t(y) * uint32_t(geometry.width) + uint32_t(x), mean.value, mean.error * how_far[random_ >> 29]});
}

}  // namespace comfort
