// SPDX-License-Identifier: BSD-3-Clause
// evalglare's patch mode (-z): bright pixels are grouped by a fixed grid of patches `angle` degrees wide, odd rows
// moved by half a patch; a pixel belongs to the nearer of two candidate centres.  Angular fisheyes only.
#include <algorithm>
#include <cmath>
#include "base/error.h"
#include "base/hypot.h"
#include "glare/sources.h"

namespace glare {

uint32_t assign_patches(std::vector<Run>& runs, const Geometry& g, const Patches& patches) {
    const view::View& v = g.projector.view();
    const int dx = int(std::floor(g.width / v.vh * patches.angle_deg)),
              dy = int(std::floor(g.height / v.vv * patches.angle_deg));
    if (dx < 1 || dy < 1) base::fail("-z", "patches of this angle are smaller than a pixel");
    // Swapped as in evalglare 3.06 (rows ang_180x90 of tests/golden/glare): if height and width of a view differ, a
    // number may name parts of two patches, and the last numbers none.
    const int nx = int(std::floor(v.vv / patches.angle_deg)) + 1, ny = int(std::floor(v.vh / patches.angle_deg)) + 1;
    const auto centre_x = [&](int k) {
        const int j = (k - 1) / nx, i = (k - 1) % nx;
        return dx / 2 + (j % 2 ? dx / 2 : 0) + i * dx;
    };
    const auto centre_y = [&](int k) { return dy / 2 + (k - 1) / nx * dy; };
    std::vector<Run> single;
    for (const Run& r : runs)
        for (uint32_t p = r.start; p < r.start + r.length; ++p) {
            const int x = g.x_of(p), y = g.y_of(p), j = y / dy;
            const double f = std::max(0.0, double(x) / dx - (j % 2 ? 0.5 : 0));
            const int a = j * nx + int(std::floor(f)) + 1;
            const int b = a + (y > centre_y(a) ? nx : -nx) + (x > centre_x(a) ? 0 : -1) + (j % 2 ? 1 : 0);
            const auto distance = [&](int k) { return base::hypot(x - centre_x(k), y - centre_y(k)); };
            const bool second = b >= 1 && b <= nx * ny && distance(b) <= distance(a);
            single.push_back({p, 1, uint32_t(second ? b : a)});
        }
    runs.swap(single);
    return uint32_t(nx * ny);
}

}  // namespace glare
