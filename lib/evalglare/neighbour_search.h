// SPDX-License-Identifier: BSD-3-Clause
// evalglare's search around a pixel (-like evalglare): row by row, first the pixel's own row and those below it, then
// those above.  In a row it steps left until a pixel is out of reach, then right, both from the middle of the stretch
// of the row before, so that it follows the lens of near pixels.  Only a pixel out of reach moves an end of the
// stretch, the picture's border does not. A pixel whose direction rounds to a length above 1 is out of its own reach:
// in its own row both steps end at once. That is how single bright pixels in one row stay apart in evalglare.
#pragma once
#include <cstdlib>
#include <vector>
#include "glare/geometry.h"

namespace evalglare {
using base::Vec3;
using glare::Geometry;

// Directions no farther apart than half an opening angle, by their dot product; no pixel more than `rows` away is.
struct AngularRadius {
    double lowest;
    int rows;
    bool holds(double cosine) const { return cosine >= lowest && cosine <= 1; }
};

class NeighbourSearch {
public:
    explicit NeighbourSearch(const Geometry& geometry);
    AngularRadius radius(double opening) const;
    // Shows every pixel in reach, by index, to stop(), whose `true` ends this half of the search; returns nothing:
    // stop() keeps its own results.  Columns beyond `last_column` are not visited.
    template <class Stop>
    void around(int x, int y, const AngularRadius& radius, int last_column, Stop stop) const {
        half(x, y, y, -1, radius, last_column, stop);
        half(x, y, y + 1, 1, radius, last_column, stop);
    }
    Vec3 direction(size_t i) const { return direction_[i]; }

private:
    template <class Stop>
    void half(int x, int y, int first, int step, const AngularRadius& radius, int last_column, Stop& stop) const {
        const Vec3 from = direction_[geometry_.index(x, y)];
        int low = x, high = x;
        for (int row = first; row >= 0 && row < geometry_.height && std::abs(row - y) <= radius.rows; row += step) {
            const size_t start = geometry_.index(0, row);
            for (int c = (low + high) / 2; c >= 0; --c) {
                if (!radius.holds(dot(from, direction_[start + c]))) {
                    low = c + 1;
                    break;
                }
                if (stop(start + c)) return;
            }
            for (int c = (low + high) / 2; c <= last_column; ++c) {
                if (!radius.holds(dot(from, direction_[start + c]))) {
                    high = c - 1;
                    break;
                }
                if (stop(start + c)) return;
            }
        }
    }
    double rows_per_radian(double reach_rad) const;

    const Geometry& geometry_;
    std::vector<Vec3> direction_;
};

}  // namespace evalglare
