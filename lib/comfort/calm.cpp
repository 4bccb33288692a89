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
constexpr int most_radius = 2, rows = 2 * most_radius + 1;
constexpr int kept_rows = 8;  // of variances: at least `rows`

// How far errors lie off, in standard errors: the middles of eight equally likely parts of a half normal distribution,
// scaled to a mean square of 1.
constexpr float how_far[how_far_of] = {.082f, .247f, .419f, .603f, .808f, 1.051f, 1.371f, 1.938f};

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

// Where noise may have carried a pixel over the threshold or below it: bit k of up to 32.
WIDE_LOOP uint32_t in_doubt(const float* grey, const float* variance, int n, float threshold) {
    uint32_t found = 0;
    for (int k = 0; k < n; ++k) {
        const float off = grey[k] - threshold;
        found |= uint32_t(!(off * off > doubt * doubt * variance[k])) << k;
    }
    return found;
}

// The rows around eight pixels, from most_radius columns before the first of them.  A variance below 0 marks a pixel
// that does not count.
constexpr int columns = lanes + 2 * most_radius;
struct Surroundings {
    const float *grey[rows], *variance[rows];
};
struct Means {
    float mean[lanes], error[lanes];
};

WIDE_LOOP void average(const Surroundings& from, int radius, Means& to) {
    Floats weights = {}, sum = {}, errors = {};
    const Floats none = {}, own = load(from.grey[most_radius] + most_radius);
    const Floats variance = load(from.variance[most_radius] + most_radius);
    for (int r = most_radius - radius; r <= most_radius + radius; ++r)
        for (int c = most_radius - radius; c <= most_radius + radius; ++c) {
            const Floats other = load(from.grey[r] + c), its = load(from.variance[r] + c);
            const Floats d = other - own, square = d * d, left = likeness * (variance + its) - square;
            const Floats share = left > none ? left / (left + square) : none + 1;
            const Floats weight = left < none ? none : its < none ? none : share * share;
            weights += weight, sum += weight * other, errors += weight * weight * its;
        }
    for (int k = 0; k < lanes; ++k) to.mean[k] = sum[k] / weights[k];
    for (int k = 0; k < lanes; ++k) to.error[k] = std::sqrt(errors[k]) / weights[k];
}

}  // namespace

void Calm::begin(const Geometry& geometry, double threshold_cdm2) {
    radius_ = radius_of(geometry);
    threshold_ = grey_limit(threshold_cdm2);
    replaced_.clear();
    variance_.resize(size_t(kept_rows * geometry.width));
    row_means_.resize(size_t(rows * geometry.width));
    zeros_.resize(size_t(geometry.width));
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
    const size_t row = size_t(y) * geometry.width;
    const float* row_variance = variance(geometry, y);
    constexpr int block = 4 * lanes;
    for (size_t s = geometry.row_spans[y]; s < geometry.row_spans[y + 1]; ++s)
        for (int x = geometry.spans[s].begin; x < geometry.spans[s].end; x += block) {
            const int n = std::min(block, geometry.spans[s].end - x);
            const uint32_t bits = in_doubt(&noisy[row + x], row_variance + x, n, threshold_);
            for (int part = 0; part < block; part += lanes)
                if (bits >> part & 0xff) average_doubtful(noisy, geometry, x + part, y, bits >> part & 0xff);
        }
}

// Of the pixels from column x of row y those whose bits are set.
void Calm::average_doubtful(const std::vector<float>& noisy, const Geometry& geometry, int x, int y, uint32_t bits) {
    const int w = geometry.width;
    const size_t first = size_t(y) * w + x;
    Surroundings near;
    float grey_room[rows][columns], variance_room[rows][columns];
    const int begin = std::max(0, x - most_radius), end = std::min(w, x + lanes + most_radius);
    for (int r = 0; r < rows; ++r) {
        const int row = y + r - most_radius;
        const bool inside = row >= 0 && row < geometry.height;
        const int from = std::clamp(row, 0, geometry.height - 1);
        near.grey[r] = &noisy[size_t(from) * w + begin], near.variance[r] = variance(geometry, from) + begin;
        if (inside && end - begin == columns) continue;
        std::fill_n(grey_room[r], columns, 0.f);
        std::fill_n(variance_room[r], columns, -1.f);
        if (inside) std::copy_n(near.grey[r], end - begin, grey_room[r] + begin - (x - most_radius));
        if (inside) std::copy_n(near.variance[r], end - begin, variance_room[r] + begin - (x - most_radius));
        near.grey[r] = grey_room[r], near.variance[r] = variance_room[r];
    }
    Means means;
    average(near, radius_, means);
    for (int k = 0; k < lanes; ++k) {
        if (!(bits >> k & 1)) continue;
        random_ = random_ * 1664525u + 1013904223u;
        replaced_.push_back({uint32_t(first) + uint32_t(k), means.mean[k], means.error[k] * how_far[random_ >> 29]});
    }
}

}  // namespace comfort
