// SPDX-License-Identifier: BSD-3-Clause
// Maps of points: which cell a place belongs to, values between points, where the contour runs.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "display/point_cells.h"
#include "display/point_map.h"

using namespace display;

namespace {

// nx by ny points, a and b apart, along `right` and `up`.
std::vector<image::Point> grid(int nx, int ny, base::Vec3 right, base::Vec3 up, base::Vec3 normal) {
    std::vector<image::Point> out;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) out.push_back({double(i) * right + double(j) * up + base::Vec3{5, 7, 1}, normal});
    return out;
}

std::vector<Rectangle> rectangles(const Canvas& canvas, const Colour& colour) {
    for (const auto& [c, all] : canvas.layers)
        if (c == colour) return all;
    return {};
}

Canvas map_of(const std::vector<image::Point>& points, const std::vector<double>& values, double limit) {
    return point_maps({"g"}, {points}, {{"lx", limit, {values}, {}, ""}});
}

}  // namespace

TEST_CASE("a place belongs to the point of its cell, on floors, walls and turned grids; none beyond") {
    const double s = std::sqrt(.5);
    const std::pair<base::Vec3, base::Vec3> axes[] = {
        {{.5, 0, 0}, {0, .25, 0}},                      // a floor
        {{s * .5, s * .5, 0}, {-s * .25, s * .25, 0}},  // turned by 45 degrees
        {{.9 * .5, -.436 * .5, 0}, {.436 * .5, .9 * .5, 0}}};
    for (const auto& [right, up] : axes) {
        const std::vector<image::Point> points = grid(6, 4, right, up, {0, 0, 1});
        const PointCells cells(points);
        const double a = base::length(right), b = base::length(up);
        double low_x = 1e9, low_y = 1e9;
        for (const double u : {-.5, 5.5})
            for (const double v : {-.5, 3.5}) {
                low_x = std::min(low_x, (u * right + v * up).x), low_y = std::min(low_y, (u * right + v * up).y);
            }
        CHECK(cells.cell() == doctest::Approx(std::min(a, b)));
        PointCells::Place place;
        const auto look = [&](double u, double v) {
            const base::Vec3 at = u * right + v * up;
            cells.look(at.x - low_x, at.y - low_y, place);
            return place.point;
        };
        CHECK(look(.4, .4) == 0);
        CHECK(look(-.4, -.4) == 0);
        CHECK(look(.6, .4) == 1);
        CHECK(look(4.6, 2.6) == 6 * 3 + 5);
        CHECK(look(5.6, 2.6) == -1);
        look(2.25, 1.5);  // between points: bilinear
        double sum = 0, u = 0, v = 0;
        for (const auto& [k, w] : place.near)
            sum += double(w), u += double(w) * (k % 6), v += double(w) * double(k / 6);
        CHECK(u / sum == doctest::Approx(2.25).epsilon(1e-4));
        CHECK(v / sum == doctest::Approx(1.5).epsilon(1e-4));
    }
}

TEST_CASE("a wall is seen from its front; a line of points, one point, and two at one place have cells, too") {
    const PointCells wall(grid(4, 3, {0, .5, 0}, {0, 0, .5}, {-1, 0, 0}));  // faces -x: its +y is on the left
    PointCells::Place place;
    wall.look(.25, .25, place);
    CHECK(place.point == 3);
    CHECK(wall.width() == doctest::Approx(2));
    CHECK(wall.height() == doctest::Approx(1.5));
    const PointCells line(grid(5, 1, {.3, 0, 0}, {}, {0, 0, 1}));
    CHECK(line.width() == doctest::Approx(1.5));
    CHECK(line.height() == doctest::Approx(.3));
    const PointCells one(grid(1, 1, {}, {}, {0, 0, 1})), same(grid(2, 1, {}, {}, {0, 0, 1}));
    CHECK(one.width() > 0);
    CHECK(same.height() > 0);
}

TEST_CASE("what is drawn of a point is what the pointer finds there, on turned grids and scattered points, too") {
    const double s = std::sqrt(.5);
    std::vector<image::Point> scattered;
    for (int k = 0; k < 40; ++k) scattered.push_back({{std::fmod(k * .618, 1), std::fmod(k * .7548, 1), 0}, {0, 0, 1}});
    for (const auto& points :
         {grid(9, 4, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), grid(5, 5, {s, s, 0}, {-s, s, 0}, {0, 0, 1}), scattered,
          grid(1, 1, {1, 0, 0}, {0, 1, 0}, {0, 0, 1})}) {
        std::vector<double> values;
        for (size_t k = 0; k < points.size(); ++k) values.push_back(double(k + 1));
        const MapColumn column{"lx", {}, {values}, {}, ""};
        const Canvas c =
            point_maps({"g"}, {points}, {column, column}, [](size_t, size_t point) { return std::to_string(point); });
        REQUIRE(c.spots.size() == points.size());
        CHECK(c.spots_again == std::vector<int>{396});
        long drawn = 0, found = 0;
        const auto area = [](const Rectangle& r) { return long(r.width) * r.height; };
        for (const auto& [colour, all] : c.layers)
            for (const Rectangle& r : all)
                if (r.x >= 12 && r.x < 396 && r.y >= 28 && r.y < c.height - 75) drawn += area(r);
        std::vector<int> owner(size_t(c.width) * size_t(c.height), -1);
        for (size_t k = 0; k < points.size(); ++k) {
            CHECK(c.spots[k].text == std::to_string(k));
            for (const Rectangle& r : c.spots[k].parts) {
                found += area(r);
                for (int y = r.y; y < r.y + r.height; ++y)
                    for (int x = r.x; x < r.x + r.width; ++x) {
                        int& here = owner[size_t(y) * size_t(c.width) + size_t(x)];
                        CHECK(here == -1);  // of one point only
                        here = int(k);
                    }
            }
        }
        CHECK(found == drawn);
    }
    const auto many = grid(400, 400, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});  // cells of a pixel
    CHECK(point_maps({"g"}, {many}, {{"lx", {}, {std::vector<double>(160000, 1.)}, {}, ""}}, [](size_t, size_t) {
              return "x";
          }).spots.empty());
}

TEST_CASE("colours from the least to the greatest value, a contour where values between points pass the limit") {
    const std::vector<image::Point> points = grid(5, 3, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
    std::vector<double> values;
    for (int k = 0; k < 15; ++k) values.push_back(100 + 100 * (k % 5));
    values[7] = NAN;
    const Canvas canvas = map_of(points, values, 250);
    const std::vector<Rectangle> line = rectangles(canvas, {255, 255, 255});
    REQUIRE(line.size() >= 2);
    CHECK(line[0].x == doctest::Approx(12 + 2 * 24).epsilon(.05));  // halfway between columns 1 and 2, 24 pixels each
    CHECK(rectangles(canvas, {238, 238, 238}).size() == 1);         // what is not known
    CHECK(map_of(points, values, 900).layers.size() < canvas.layers.size());
    CHECK(point_maps({}, {}, {}).height > 0);
}
