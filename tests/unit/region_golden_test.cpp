// SPDX-License-Identifier: BSD-3-Clause
// With -centre a circle holds the pixels of evalglare's task area: the task luminance of its -t (column L_t of -d,
// evalglare 3.06) is the solid-angle mean over our circle, in golden/region_tasks.tsv: picture, x, y, angle (rad), L_t.
// evalglare means every pixel with a direction, also those behind the eye, whose luminance it has set to 0; and it
// finds the solid angle in the mirrored row, which matters only with a lift.  Where its rounding makes the cosine of 0
// exceed 1, it loses the centre pixel itself, as it does in per_office.hdr.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <fmt/format.h>
#include "region/region.h"
#include "region/shape.h"
#include "image/stream.h"

TEST_CASE("circles by pixel centres are evalglare's task areas") {
    const std::string folder = LUXPIPE_TESTS "/golden/";
    std::ifstream in(folder + "region_tasks.tsv");
    REQUIRE(in);
    std::string name;
    int x, y, rows = 0;
    double angle, expected;
    while (in >> name >> x >> y >> angle >> expected) {
        image::Picture p = image::read_file(folder + "images/" + name);
        REQUIRE(p.header.view);
        const view::View& v = *p.header.view;
        auto r = region::parse(fmt::format("task circle {} {} {:.17g}rad", x, y, double(float(angle))), "test");
        auto mask = region::rasterize(r, v, p.width, p.height, true).masks[0].coverage;
        region::Space space(v, p.width, p.height);
        double sum = 0, omega = 0, centre_sum = 0, centre_omega = 0;
        long n = 0;
        for (size_t i = 0; i < mask.size(); ++i) {
            if (mask[i] == 0) continue;
            int px = int(i) % p.width, py = p.height - 1 - int(i) / p.width;
            double w = view::pixel_solid_angle(space.projector, px, py, p.width, p.height);
            const float* c = &p.rgb[3 * i];
            double l = 179 * (0.26510582010582007 * c[0] + 0.67010582010581987 * c[1] + 0.064788359788359784 * c[2]);
            if (!space.counts(px + .5, py + .5) || w <= 0) l = 0;
            sum += w * l;
            omega += w;
            if (px == x && py == y) centre_sum = w * l, centre_omega = w;
            ++n;
        }
        CAPTURE(name);
        CAPTURE(x);
        CAPTURE(y);
        CAPTURE(angle);
        CAPTURE(n);
        double off = std::fabs(sum / omega - expected);
        double off_without_centre = std::fabs((sum - centre_sum) / (omega - centre_omega) - expected);
        CHECK(std::min(off, off_without_centre) <= 1e-6 * expected + 1e-6);
        ++rows;
    }
    CHECK(rows > 5);
}
