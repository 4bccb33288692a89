// SPDX-License-Identifier: BSD-3-Clause
// Points in a plane and the cells around them: which point a place belongs to, and values between points.
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

#include "image/points.h"

namespace display {

class PointCells {
public:
    explicit PointCells(const std::vector<image::Point>& points);

    // The size of all cells together, x to the right and y up.
    double width() const { return high_.first - low_.first; }
    double height() const { return high_.second - low_.second; }
    double cell() const { return side_[0] < side_[1] ? side_[0] : side_[1]; }  // its shorter side

    struct Place {
        int point = -1;  // whose cell it is; -1: none
        std::vector<std::pair<uint32_t, float>>
            near;  // weights of a tent as wide as two cells: bilinear in a regular grid
    };
    // From the lower left corner.
    void look(double x, double y, Place& place) const;

private:
    using Pair = std::pair<double, double>;
    void turn_to_rows();
    void measure_sides();
    void sort(double side);
    template <class Use>
    void visit(double x, double y, int rings, const Use& use) const;

    std::vector<Pair> at_;          // in the plane, turned so that rows of a regular grid are along x
    double cosine_ = 1, sine_ = 0;  // of that turn
    double side_[2] = {1, 1};       // of cells, along and across rows
    Pair low_, high_;               // in the plane, not turned
    // bins
    double bin_ = 1;
    Pair origin_;
    int across_ = 1, down_ = 1;
    std::vector<uint32_t> first_, sorted_;
};

}  // namespace display
