// SPDX-License-Identifier: BSD-3-Clause
// Views: RADIANCE's vwrays and evalglare's pixels as outside witnesses, laws for the rest: projecting is the
// inverse of looking, solid angles of a whole view add up to what geometry says.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/options.h"
#include "temp_folder.h"
#include "view/view.h"

using view::Projector;
using view::View;

namespace {

View parse(const std::string& words) {
    View v;
    view::parse_line(v, words);
    return v;
}

std::string error_of(const std::string& words) {
    try {
        view::validate(parse(words));
    } catch (const base::Error& e) {
        return e.where;
    }
    return "";
}

std::vector<std::vector<std::string>> table(const char* name) {
    std::ifstream in(std::string(LUXPIPE_TESTS) + "/golden/" + name);
    REQUIRE(in);
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);) {
        if (line.empty() || line[0] == '#') continue;
        std::vector<std::string> cells;
        std::istringstream cut(line);
        for (std::string cell; std::getline(cut, cell, '\t');) cells.push_back(cell);
        rows.push_back(cells);
    }
    return rows;
}

double omega_of_view(const std::string& words, int nx, int ny) {
    const Projector p(parse(words));
    double sum = 0;
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) sum += view::pixel_solid_angle(p, i, j, nx, ny);
    return sum;
}

const char* all_views[] = {"-vtv -vp 1 2 3 -vd 1 .5 -.2 -vh 60 -vv 45 -vs .1",
                           "-vtl -vd 0 0 -1 -vu 0 1 0 -vh 4 -vv 3",
                           "-vta -vd 1 1 0 -vh 180 -vv 180 -vl .05",
                           "-vta -vd 1 1 0 -vh 330 -vv 330",
                           "-vth -vd 0 1 .5 -vh 180 -vv 150",
                           "-vts -vd -1 0 0 -vh 200 -vv 160",
                           "-vtc -vd 0 1 0 -vh 360 -vv 90 -vl -.1"};

}  // namespace

TEST_CASE("rays are vwrays' to its six digits") {
    const auto rows = table("vwrays.tsv");
    CHECK(rows.size() == 56);
    for (const auto& row : rows) {
        CAPTURE(row[0]);
        CAPTURE(row[1] + " " + row[2]);
        double want[6];
        std::istringstream numbers(row[3]);
        for (double& w : want) numbers >> w;
        const auto ray = Projector(parse(row[0])).ray((std::stod(row[1]) + .5) / 8, (5 - std::stod(row[2]) + .5) / 6);
        const bool none = want[3] == 0 && want[4] == 0 && want[5] == 0;
        CHECK(ray.has_value() == !none);
        if (!ray) continue;
        for (int i = 0; i < 3; ++i) {
            CHECK(ray->origin[i] == doctest::Approx(want[i]).epsilon(5e-6));
            CHECK(std::fabs(ray->dir[i] - want[i + 3]) < 2e-6);
        }
    }
}

TEST_CASE("directions and solid angles are evalglare's") {
    for (const auto& row : table("pixel_angles.tsv")) {
        CAPTURE(row[0]);
        CAPTURE(row[3] + " " + row[4]);
        const int nx = std::stoi(row[1]), ny = std::stoi(row[2]), x = std::stoi(row[3]), y = std::stoi(row[4]);
        const Projector p(parse(row[0]));
        const auto dir = p.direction((x + .5) / nx, (y + .5) / ny);
        const double omega = std::stod(row[8]);
        if (dir)
            for (int i = 0; i < 3; ++i) CHECK(std::fabs((*dir)[i] - std::stod(row[5 + i])) < 1e-9);
        // evalglare sums four angles near pi/2, which costs it digits: 1e-16 of 2 pi against a pixel of 1e-5
        CHECK(std::fabs(view::pixel_solid_angle(p, x, y, nx, ny) - (omega > 0 ? omega : 0)) < 1e-6 * omega + 1e-12);
    }
}

TEST_CASE("locating a direction is the inverse of looking there") {
    for (const char* words : all_views) {
        CAPTURE(words);
        const Projector p(parse(words));
        for (double X = .03; X < 1; X += .094)
            for (double Y = .05; Y < 1; Y += .11) {
                const auto ray = p.ray(X, Y);
                if (!ray || p.view().type == 'l') continue;
                double x = -9, y = -9;
                CHECK(p.locate_direction(ray->dir, x, y));
                CHECK(x == doctest::Approx(X).epsilon(1e-9));
                CHECK(y == doctest::Approx(Y).epsilon(1e-9));
            }
    }
}

TEST_CASE("solid angles add up") {
    // Perspective: a rectangle seen from its axis, 4 asin(sin(h/2) sin(v/2)) with h, v the full angles of its sides.
    const double h = 60 * M_PI / 180, v = 45 * M_PI / 180;
    CHECK(omega_of_view("-vtv -vh 60 -vv 45", 40, 30) ==
          doctest::Approx(4 * std::asin(std::sin(h / 2) * std::sin(v / 2))).epsilon(1e-10));
    // Full sphere; the pixels at the rim that have a corner outside count nothing, about 2/n of the disc's area
    // where the sphere is squeezed to nothing.
    CHECK(omega_of_view("-vta -vh 360 -vv 360", 400, 400) == doctest::Approx(4 * M_PI).epsilon(.002));
    // Cylinder: 360 degrees between +-45 degrees of elevation is 4 pi sin(45).  Great circles instead of the
    // band's edges: of order (pixel width)^2.
    CHECK(omega_of_view("-vtc -vh 360 -vv 90", 720, 60) == doctest::Approx(4 * M_PI * std::sqrt(.5)).epsilon(1e-4));
}

TEST_CASE("a small pixel's solid angle keeps its digits") {
    // At the centre of an angular fisheye a pixel of angle t is a square of t^2 (1 - t^2/6 ...).
    const Projector p(parse("-vta -vh 180 -vv 180"));
    for (const int n : {512, 4096, 32768}) {
        const double t = M_PI / n;
        CHECK(view::pixel_solid_angle(p, n / 2, n / 2, n, n) / (t * t) == doctest::Approx(1).epsilon(t * t + 1e-11));
    }
}

TEST_CASE("clipping planes for perspective, spheres for fisheyes") {
    const Projector plane(parse("-vtv -vh 90 -vv 90 -vo 1 -va 3"));
    const auto corner = plane.ray(1, .5);  // 45 degrees to the right: a plane is sqrt(2) farther there
    CHECK(corner->origin.y == doctest::Approx(1));
    CHECK(corner->tmax == doctest::Approx(2 * std::sqrt(2.)));
    const Projector sphere(parse("-vta -vh 90 -vv 90 -vo 1 -va 3"));
    CHECK(sphere.ray(1, .5)->tmax == doctest::Approx(2));
    CHECK(base::length(sphere.ray(1, .5)->origin) == doctest::Approx(1));
    CHECK(Projector(parse("-vta")).ray(.5, .5)->tmax == 0);
}

TEST_CASE("sizes fit the view as rpict fits them") {
    int nx = 100, ny = 100;
    view::fit_size(parse("-vtv -vh 60 -vv 40"), 1, nx, ny);
    CHECK(nx == 100);
    CHECK(ny == 63);  // vwrays -d -vh 60 -vv 40 -x 100 -y 100
    nx = ny = 100;
    view::fit_size(parse("-vtv -vh 60 -vv 40"), 0, nx, ny);
    CHECK(ny == 100);
}

TEST_CASE("views survive their own words") {
    for (const char* words : all_views) {
        const View v = parse(words);
        CHECK(parse("VIEW=" + view::to_options(v)) == v);
    }
    View odd;
    odd.vp = {1. / 3, 1e-7, -12345.678};
    odd.vh = 59.123456789012345;
    CHECK(parse("VIEW=" + view::to_options(odd)) == odd);
}

TEST_CASE("header lines that hold views") {
    CHECK(view::is_view_line("VIEW= -vta"));
    CHECK(view::is_view_line("/usr/bin/rpict -vtv"));
    CHECK_FALSE(view::is_view_line("\tVIEW= -vta"));  // an input's history
    CHECK_FALSE(view::is_view_line("pfilt -1 -vta"));
    View v;
    CHECK(view::parse_line(v, "rpict -x 7 -vp 1 2 3 -vta -bogus -vh scene.oct"));
    CHECK(v.type == 'a');
    CHECK(v.vp == base::Vec3{1, 2, 3});
    CHECK(v.vh == 45);  // its argument was missing
}

TEST_CASE("options: words used, later ones win, bad arguments name the option") {
    View v;
    base::OptionTable table;
    view::declare_options(table, v);
    const auto words_used = [&](const std::vector<std::string>& words) {
        std::string wrong;
        const bool any = table.read_header_words(words, wrong);
        if (!wrong.empty()) base::fail("", wrong);
        return any ? table.parsed().back().words.size() : 0;
    };
    CHECK(words_used({"-vp", "1", "2", "3"}) == 4);
    CHECK(words_used({"-vta"}) == 1);
    CHECK(words_used({"-vh", "60"}) == 2);
    CHECK(words_used({"-vf", "file"}) == 0);
    CHECK(words_used({"-v"}) == 0);
    CHECK(words_used({"-ab", "2"}) == 0);
    CHECK_THROWS_WITH_AS(words_used({"-vp", "1", "2"}), "-vp: an argument is missing (-vp x y z)", base::Error);
    CHECK_THROWS_WITH_AS(words_used({"-vp", "1", "2", "x"}), "-vp: \"x\" is not a number", base::Error);
    CHECK_THROWS_AS(words_used({"-vtx"}), base::Error);
    CHECK_THROWS_AS(words_used({"-vt"}), base::Error);
    CHECK(v.vp == base::Vec3{1, 2, 3});
}

TEST_CASE("impossible views are refused with the option as place") {
    CHECK(error_of("-vtv -vh 180") == "-vh");
    CHECK(error_of("-vta -vh 361 -vv 90") == "-vh");
    CHECK(error_of("-vth -vh 90 -vv 181") == "-vv");
    CHECK(error_of("-vts -vh 360 -vv 90") == "-vh");
    CHECK(error_of("-vtc -vh 360 -vv 180") == "-vv");
    CHECK(error_of("-vh 0") == "-vh");
    CHECK_THROWS_WITH(view::validate(parse("-vh 1e-9")), "-vh: 1e-09 is not above 1e-06");
    CHECK(error_of("-vd 0 0 0") == "-vd");
    CHECK(error_of("-vd 0 0 2 -vu 0 0 1") == "-vu");
    CHECK(error_of("-vo 2 -va 1") == "-va");
    CHECK(error_of("-vth -vh 180 -vv 180") == "");
}

TEST_CASE("view files: the last view wins, options missing there stay") {
    TempFolder temp;
    const std::string path = temp.name("a.vf");
    std::ofstream(path) << "rvu -vtv -vp 1 1 1\nVIEW= -vta -vh 170 -vv 170\n";
    View v;
    v.vu = {0, 1, 0};
    view::apply_view_file(v, path);
    CHECK(v.type == 'a');
    CHECK(v.vp == base::Vec3{1, 1, 1});
    CHECK(v.vu == base::Vec3{0, 1, 0});
    std::ofstream(path) << "nothing here\n";
    CHECK_THROWS_AS(view::read_view_file(path), base::Error);
    std::remove(path.c_str());
    CHECK_THROWS_AS(view::read_view_file(path), base::Error);
}
