// SPDX-License-Identifier: BSD-3-Clause
// See point_cells.h.
#include "display/point_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/hypot.h"

namespace display {
namespace {

using base::Vec3;
using Pair = std::pair<double, double>;
constexpr size_t most_asked = 2000;  // points, for directions and distances of neighbours
constexpr double infinite = std::numeric_limits<double>::infinity();

std::vector<Pair> along(const std::vector<image::Point>& points, Vec3 normal) {
    const Vec3 z{0, 0, 1}, steep = z - normal * normal.z;
    const Vec3 up = base::length(steep) > 1e-3 ? base::unit(steep) : Vec3{0, 1, 0}, right = base::cross(up, normal);
    std::vector<Pair> out;
    for (const image::Point& point : points) out.push_back({dot(point.p, right), dot(point.p, up)});
    return out;
}

// Lower left and upper right corner.
std::pair<Pair, Pair> corners(const std::vector<Pair>& all) {
    Pair low{infinite, infinite}, high{-infinite, -infinite};
    for (const auto& [x, y] : all) {
        low = {std::min(low.first, x), std::min(low.second, y)};
        high = {std::max(high.first, x), std::max(high.second, y)};
    }
    return {low, high};
}

// From above; else from where points spread clearly more.
std::vector<Pair> in_plane(const std::vector<image::Point>& points) {
    Vec3 mean;
    for (const image::Point& point : points) mean = mean + point.dir * (1 / double(points.size()));
    std::vector<Pair> best;
    double most = -1;
    for (const Vec3 normal : {Vec3{0, 0, 1}, base::unit(mean), Vec3{0, -1, 0}, Vec3{1, 0, 0}}) {
        if (!(base::length(normal) > .5)) continue;
        std::vector<Pair> all = along(points, normal);
        const auto [low, high] = corners(all);
        const double wide = high.first - low.first, long_ = high.second - low.second;
        if (const double area = wide * long_ + 1e-3 * (wide * wide + long_ * long_); area > 1.01 * most)
            most = area, best = std::move(all);
    }
    return best;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + long(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

}  // namespace

PointCells::PointCells(const std::vector<image::Point>& points) : at_(in_plane(points)) {
    std::tie(low_, high_) = corners(at_);
    const double n = double(points.size());
    sort(std::max({std::sqrt(width() * height() / n), width() / n, height() / n}));
    turn_to_rows();
    measure_sides();
    sort(std::max(side_[0], side_[1]));
    const double x = (std::fabs(cosine_) * side_[0] + std::fabs(sine_) * side_[1]) / 2,
                 y = (std::fabs(sine_) * side_[0] + std::fabs(cosine_) * side_[1]) / 2;
    low_ = {low_.first - x, low_.second - y}, high_ = {high_.first + x, high_.second + y};
}

// Bins of this side, or of a larger one where there would be many more than points.
void PointCells::sort(double side) {
    const auto [low, high] = corners(at_);
    origin_ = low;
    const double wide = high.first - low.first, long_ = high.second - low.second, most = 4 * double(at_.size()) + 16;
    bin_ = side > 0 ? side : 1;
    while ((wide / bin_ + 1) * (long_ / bin_ + 1) > most) bin_ *= 2;
    across_ = int(wide / bin_) + 1, down_ = int(long_ / bin_) + 1;
    std::vector<uint32_t> bin;
    for (const auto& [x, y] : at_)
        bin.push_back(uint32_t(int((y - low.second) / bin_) * across_ + int((x - low.first) / bin_)));
    first_.assign(size_t(across_) * size_t(down_) + 1, 0);
    for (const uint32_t b : bin) first_[b + 1]++;
    for (size_t b = 1; b < first_.size(); ++b) first_[b] += first_[b - 1];
    std::vector<uint32_t> next(first_.begin(), first_.end() - 1);
    sorted_.resize(at_.size());
    for (size_t i = 0; i < at_.size(); ++i) sorted_[next[bin[i]]++] = uint32_t(i);
}

// use(point, dx, dy) of the points in bins at most so many from the place's own.
template <class Use>
void PointCells::visit(double x, double y, int rings, const Use& use) const {
    const int i = int(std::floor((x - origin_.first) / bin_)), j = int(std::floor((y - origin_.second) / bin_));
    for (int b = std::max(j - rings, 0); b <= std::min(j + rings, down_ - 1); ++b)
        for (int a = std::max(i - rings, 0); a <= std::min(i + rings, across_ - 1); ++a)
            for (uint32_t k = first_[size_t(b * across_ + a)]; k < first_[size_t(b * across_ + a) + 1]; ++k)
                use(sorted_[k], at_[sorted_[k]].first - x, at_[sorted_[k]].second - y);
}

// Turns the points so that their rows lie along x: the mean direction from point to nearest neighbour, where a quarter
// turn counts as none (the mean of four times the angle).
void PointCells::turn_to_rows() {
    double cosines = 0, sines = 0;
    for (size_t i = 0; i < at_.size(); i += 1 + at_.size() / most_asked) {
        double nearest = infinite, dx = 0, dy = 0;
        for (int rings = 1; std::isinf(nearest) && rings / 2 < std::max(across_, down_); rings *= 2)
            visit(at_[i].first, at_[i].second, rings, [&](uint32_t, double x, double y) {
                if (const double d = base::hypot(x, y); d > 1e-6 * bin_ && d < nearest) nearest = d, dx = x, dy = y;
            });
        const double four = 4 * std::atan2(dy, dx);
        if (std::isfinite(nearest)) cosines += std::cos(four), sines += std::sin(four);
    }
    const double turn = std::atan2(sines, cosines) / 4;
    cosine_ = std::cos(turn), sine_ = std::sin(turn);
    for (auto& [x, y] : at_) std::tie(x, y) = std::pair(cosine_ * x + sine_ * y, cosine_ * y - sine_ * x);
    sort(bin_);
}

void PointCells::measure_sides() {
    constexpr int rings = 4;
    std::vector<double> near[2];
    for (size_t i = 0; i < at_.size(); i += 1 + at_.size() / most_asked) {
        double nearest[2] = {infinite, infinite};
        visit(at_[i].first, at_[i].second, rings, [&](uint32_t, double x, double y) {
            x = std::fabs(x), y = std::fabs(y);
            if (x > 1e-6 * bin_ && y < x / 4) nearest[0] = std::min(nearest[0], x);
            if (y > 1e-6 * bin_ && x < y / 4) nearest[1] = std::min(nearest[1], y);
        });
        for (int k = 0; k < 2; ++k)
            if (std::isfinite(nearest[k])) near[k].push_back(nearest[k]);
    }
    for (int k = 0; k < 2; ++k)
        if (!near[k].empty()) side_[k] = median(near[k]);
    for (int k = 0; k < 2; ++k)
        if (near[k].empty()) side_[k] = near[1 - k].empty() ? bin_ : side_[1 - k];
}

void PointCells::look(double x, double y, Place& place) const {
    x += low_.first, y += low_.second;
    place.point = -1;
    place.near.clear();
    double nearest = infinite;
    visit(cosine_ * x + sine_ * y, cosine_ * y - sine_ * x, 1, [&](uint32_t point, double dx, double dy) {
        dx = std::fabs(dx) / side_[0], dy = std::fabs(dy) / side_[1];
        if (std::max(dx, dy) < 1) place.near.push_back({point, float((1 - dx) * (1 - dy))});
        if (const double d = dx * dx + dy * dy; std::max(dx, dy) <= .5 + 1e-6 && d < nearest)
            nearest = d, place.point = int(point);
    });
}

}  // namespace display
