// SPDX-License-Identifier: BSD-3-Clause
// Sizes of the regions, and the cost of small ones: frames to convergence go with 1 / region size, and the
// paper needs about 1000 frames for contrast regions of 32 pixels (its Figs. 7 and 8).
#include <cmath>
#include <fmt/format.h>
#include "base/error.h"
#include "region/raster.h"

namespace region {

std::vector<Extent> measure(const image::MaskSet& set, const view::View& view) {
    const int nx = set.width, ny = set.height;
    Space space(view, nx, ny);
    struct Row {
        double omega = 0, pixels = 0;
        std::vector<Extent> sums;
    };
    std::vector<Row> rows{size_t(ny)};
    for_all(size_t(ny), [&](size_t r) {
        Row& row = rows[r];
        row.sums.resize(set.masks.size());
        int y = ny - 1 - int(r);
        for (int x = 0; x < nx; ++x) {
            if (!space.counts(x + .5, y + .5)) continue;
            Point p;
            space.point(x + .5, y + .5, p);
            double omega = view::pixel_solid_angle(space.projector, x, y, nx, ny);
            if (omega <= 0 && space.behind == 0) continue;  // cut by the rim of a hemispherical view
            row.omega += omega;
            row.pixels += 1;
            for (size_t m = 0; m < set.masks.size(); ++m) {
                double c = set.masks[m].coverage[r * size_t(nx) + size_t(x)];
                if (c == 0) continue;
                row.sums[m].pixels += c;
                row.sums[m].omega_sr += c * omega;
                row.sums[m].centre = row.sums[m].centre + p.dir * (c * (omega > 0 ? omega : 1e-12));
            }
        }
    });
    std::vector<Extent> all(set.masks.size());
    double omega = 0, pixels = 0;
    for (const Row& row : rows) {
        omega += row.omega;
        pixels += row.pixels;
        for (size_t m = 0; m < all.size(); ++m) {
            all[m].pixels += row.sums[m].pixels;
            all[m].omega_sr += row.sums[m].omega_sr;
            all[m].centre = all[m].centre + row.sums[m].centre;
        }
    }
    for (size_t m = 0; m < all.size(); ++m) {
        all[m].name = set.masks[m].name;
        all[m].centre = base::unit(all[m].centre);
        if (omega > 0) all[m].share = all[m].omega_sr / omega;
        else if (pixels > 0) all[m].share = all[m].pixels / pixels;
    }
    return all;
}

std::vector<Extent> count_pixels(const image::MaskSet& set, const view::View& view) {
    const size_t nx = size_t(set.width), ny = size_t(set.height);
    Space space(view, set.width, set.height);
    std::vector<char> counts(nx * ny);
    for_all(ny, [&](size_t r) {
        for (size_t x = 0; x < nx; ++x) counts[r * nx + x] = space.counts(double(x) + .5, double(ny - 1 - r) + .5);
    });
    std::vector<Extent> all(set.masks.size());
    for_all(all.size(), [&](size_t m) {
        all[m].name = set.masks[m].name;
        const std::vector<float>& c = set.masks[m].coverage;
        for (size_t i = 0; i < c.size(); ++i)
            if (c[i] > 0 && counts[i]) all[m].pixels += double(c[i]);
    });
    return all;
}

void check_sizes(const Regions& regions, const std::vector<Extent>& extents, bool warn_of_small) {
    for (size_t i = 0; i < extents.size(); ++i) {
        const Region& r = regions.regions[i];
        double n = extents[i].pixels;
        if (n <= 0)
            base::fail(r.place, fmt::format("region \"{}\" is empty: nothing of it can be seen in this view", r.name));
        if (n < 32 && warn_of_small) {
            double frames = 1000 * 32 / n, unit = std::pow(10, std::floor(std::log10(frames)) - 1);
            base::warn(
                r.place,
                fmt::format("region \"{}\" covers {:.3g} pixels: its means converge slowly, to 1 % in roughly {:.0f} "
                            "frames (1000 at 32 pixels; ptrace -focus samples it more)",
                            r.name, n, std::round(frames / unit) * unit));
        }
    }
}

}  // namespace region
