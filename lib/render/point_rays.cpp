// SPDX-License-Identifier: BSD-3-Clause
// See point_rays.h.
#include "render/point_rays.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "flatten/pack.h"
#include "render/sensor_starts.h"

namespace render {
using base::Vec3;
using namespace kernels;

namespace {

constexpr size_t paths_of_frame = 1u << 16;                  // a frame of a tenth of a second on a core
constexpr uint32_t most_samples = 1u << SAMPLER_BLOCK_BITS;  // one net; the next frame's is independent

// Puts neighbours next to one another: halves a rectangle of pixels and, in proportion, the points along the axis in
// which they differ most; their directions are three axes more.
class Halving {
public:
    Halving(const std::vector<image::Point>& points, PointLayout& layout) : points_(points), layout_(layout) {
        order_.resize(points.size());
        std::iota(order_.begin(), order_.end(), 0u);
        for (int axis = 0; axis < 3; axis++) size_ = std::max(size_, spread(0, order_.size(), axis));
        if (!(size_ > 0)) size_ = 1;
    }
    void fill() { fill(0, points_.size() * layout_.copies, 0, 0, layout_.nx, layout_.ny); }

private:
    const std::vector<image::Point>& points_;
    PointLayout& layout_;
    std::vector<uint32_t> order_;
    double size_ = 0;

    double value(uint32_t point, int axis) const {
        const Vec3 &p = points_[point].p, &d = points_[point].dir;
        const double all[] = {p.x, p.y, p.z, size_ * d.x, size_ * d.y, size_ * d.z};
        return all[axis];
    }
    double spread(size_t begin, size_t end, int axis) const {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (size_t i = begin; i < end; i++) {
            low = std::min(low, value(order_[i], axis));
            high = std::max(high, value(order_[i], axis));
        }
        return high - low;
    }
    // Pixels begin .. end - 1 of the points in order, each as often as it has copies.
    void fill(size_t begin, size_t end, uint32_t x, uint32_t y, uint32_t wide, uint32_t high) {
        if (begin == end) return;
        if (wide * high == 1) return put(x, y, order_[begin / layout_.copies]);
        const size_t first = begin / layout_.copies, last = (end - 1) / layout_.copies + 1;
        const bool across = wide >= high;
        const uint32_t half = (across ? wide : high) / 2;
        const size_t most = size_t(across ? half * high : half * wide),
                     rest = size_t(wide) * high - most;  // room on both sides
        size_t middle = begin + (end - begin) * most / (most + rest);
        middle = std::clamp(middle, end - std::min(end - begin, rest), begin + std::min(end - begin, most));
        if (last - first > 1) sort(first, last, (middle + layout_.copies / 2) / layout_.copies);
        fill(begin, middle, x, y, across ? half : wide, across ? high : half);
        fill(middle, end, across ? x + half : x, across ? y : y + half, across ? wide - half : wide,
             across ? high : high - half);
    }
    void sort(size_t first, size_t last, size_t middle) {
        int widest = 0;
        double most = -1;
        for (int axis = 0; axis < 6; axis++)
            if (const double s = spread(first, last, axis); s > most) most = s, widest = axis;
        const auto before = [&](uint32_t a, uint32_t b) {
            const double u = value(a, widest), v = value(b, widest);
            return u < v || (!(v < u) && a < b);
        };
        const auto at = [&](size_t i) { return order_.begin() + long(i); };
        if (middle > first && middle < last) std::nth_element(at(first), at(middle), at(last), before);
    }
    // The members of a group of path reuse are every fourth pixel of every fourth row: the picture is sixteen pictures,
    // in each of which they are neighbours.
    void put(uint32_t x, uint32_t y, uint32_t point) {
        const uint32_t wide = layout_.nx / REUSE_STRIDE, high = layout_.ny / REUSE_STRIDE;
        const uint32_t across = x % wide * REUSE_STRIDE + x / wide, down = y % high * REUSE_STRIDE + y / high;
        layout_.point[down * layout_.nx + across] = point;
    }
};

uint32_t whole_squares(double side) { return std::max(1u, uint32_t(std::ceil(side / REUSE_SIDE))) * REUSE_SIDE; }

}  // namespace

PointLayout lay_out(const std::vector<image::Point>& points) {
    PointLayout layout;
    const size_t n = points.size();
    layout.copies = uint32_t(std::max<size_t>(1, REUSE_SQUARE / n));
    const size_t pixels = n * layout.copies;
    layout.nx = whole_squares(std::sqrt(double(pixels)));
    layout.ny = whole_squares(double(pixels) / layout.nx);
    layout.point.assign(size_t(layout.nx) * layout.ny, PointLayout::none);
    layout.samples_per_frame = most_samples;
    while (layout.samples_per_frame > 1 && layout.samples_per_frame * pixels > paths_of_frame)
        layout.samples_per_frame /= 2;
    Halving(points, layout).fill();
    return layout;
}

std::vector<PointRay> point_rays(const PointList& list, const PointLayout& layout, const flatten::FlatScene& scene) {
    const std::vector<Vec3> starts = list.sensors ? sensor_starts(list.points, scene) : std::vector<Vec3>();
    std::vector<PointRay> rays(layout.point.size());
    for (size_t pixel = 0; pixel < layout.point.size(); pixel++) {
        const uint32_t k = layout.point[pixel];
        if (k == PointLayout::none) continue;
        const image::Point& point = list.points[k];
        rays[pixel] = {flatten::packed((list.sensors ? starts[k] : point.p) - scene.centre),
                       flatten::packed(point.dir * (list.sensors ? -1.0 : 1.0))};
    }
    return rays;
}

std::vector<float> in_order(const PointLayout& layout, const std::vector<float>& rgb, size_t pixels) {
    std::vector<double> sum(3 * pixels, 0.0);
    std::vector<uint32_t> count(pixels, 0);
    for (size_t pixel = 0; pixel < layout.point.size(); pixel++) {
        const uint32_t point = layout.point[pixel];
        if (point == PointLayout::none) continue;
        count[point]++;
        for (size_t c = 0; c < 3; c++) sum[3 * point + c] += double(rgb[3 * pixel + c]);
    }
    std::vector<float> out(3 * pixels);
    for (size_t i = 0; i < out.size(); i++) out[i] = count[i / 3] ? float(sum[i] / count[i / 3]) : 0;
    return out;
}

}  // namespace render
