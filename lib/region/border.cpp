// SPDX-License-Identifier: BSD-3-Clause
// See border.h.
#include "region/border.h"

namespace region {
namespace {

constexpr int halvings = 3;  // of a cell's edge, to find a border

// A square of side 1.  Corners counter-clockwise from the lower left; borders on the edges between unlike corners, as
// shares of the edge from the left or from below.
struct BorderCell {
    bool in[4];
    double below, right, above, left;

    // Two opposite corners are in: the cell's middle tells which pair of corners is joined.
    double saddle_share(bool middle) const {
        const bool low = in[0] != middle;  // the corners that are cut off
        const double cut = low ? below * left + (1 - right) * (1 - above) : (1 - below) * right + above * (1 - left);
        return middle ? 1 - cut / 2 : cut / 2;
    }

    // The polygon of the corners that are in and of the borders.
    double polygon_share() const {
        const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        const double border[4][2] = {{below, 0}, {1, right}, {above, 1}, {0, left}};
        double x[8], y[8], area = 0;
        int n = 0;
        for (int k = 0; k < 4; ++k) {
            if (in[k]) x[n] = corner[k][0], y[n++] = corner[k][1];
            if (in[k] != in[(k + 1) % 4]) x[n] = border[k][0], y[n++] = border[k][1];
        }
        for (int k = 0; k < n; ++k) area += x[k] * y[(k + 1) % n] - x[(k + 1) % n] * y[k];
        return area / 2;
    }
};

}  // namespace

double share_inside(const BorderSamples& in, const std::function<bool(double u, double v)>& inside) {
    constexpr int cells = border_cells;
    int count = 0;
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) count += in[j][i];
    if (count == 0 || count == (cells + 1) * (cells + 1)) return count > 0;

    // The border on the edge from sample (i, j) to its right or upper neighbour, as a share of the edge; each once.
    double right[cells + 1][cells] = {}, above[cells][cells + 1] = {};
    const auto border = [&](double i, double j, double di, double dj, bool from) {
        double a = 0, b = 1;
        for (int k = 0; k < halvings; ++k) {
            const double m = (a + b) / 2;
            (inside((i + m * di) / cells, (j + m * dj) / cells) == from ? a : b) = m;
        }
        return (a + b) / 2;
    };
    for (int j = 0; j <= cells; ++j)
        for (int i = 0; i <= cells; ++i) {
            if (i < cells && in[j][i] != in[j][i + 1]) right[j][i] = border(i, j, 1, 0, in[j][i]);
            if (j < cells && in[j][i] != in[j + 1][i]) above[j][i] = border(i, j, 0, 1, in[j][i]);
        }

    double sum = 0;
    for (int j = 0; j < cells; ++j)
        for (int i = 0; i < cells; ++i) {
            const BorderCell cell = {{in[j][i], in[j][i + 1], in[j + 1][i + 1], in[j + 1][i]},
                                     right[j][i],
                                     above[j][i + 1],
                                     right[j + 1][i],
                                     above[j][i]};
            const int n = cell.in[0] + cell.in[1] + cell.in[2] + cell.in[3];
            if (n == 0 || n == 4) sum += n / 4;
            else if (n == 2 && cell.in[0] == cell.in[2])
                sum += cell.saddle_share(inside((i + .5) / cells, (j + .5) / cells));
            else sum += cell.polygon_share();
        }
    return sum / (cells * cells);
}

}  // namespace region
