// SPDX-License-Identifier: BSD-3-Clause
// Laws and closed forms of the metrics.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include "base/error.h"
#include "report/compare.h"
#include "glare/columns.h"
#include "glare/measure.h"
#include "glare/rammg.h"
#include "report/table.h"
#include "report/until.h"
#include "image/grey.h"

using namespace glare;
using namespace report;

namespace {

constexpr double pi = 3.14159265358979323846;

view::View fisheye() {
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    return v;
}

// A grey picture from luminances, rows from the BOTTOM.
image::Picture picture(int w, int h, const std::vector<double>& cdm2) {
    image::Picture p;
    p.width = w, p.height = h;
    p.rgb.resize(3 * size_t(w) * h);
    for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x)
            for (int c = 0; c < 3; ++c) p.at(x, h - 1 - y)[c] = float(cdm2[size_t(y) * w + x] / 179);
    view::View v;
    v.vh = v.vv = 60;
    p.header.view = v;
    return p;
}

double rect_rammg(int w, int h, const std::vector<double>& cdm2) {
    image::Picture p = picture(w, h, cdm2);
    const Geometry g(*p.header.view, w, h);
    const Luminance lum = make_luminance(p);
    const double view = rammg(lum, Pyramid(g, RammgArea::view)), rect = rammg(lum, Pyramid(g, RammgArea::rectangle));
    if (!std::isnan(view)) CHECK(view == doctest::Approx(rect));  // every pixel of a perspective view counts
    return rect;
}

// The value of a column, such as "DGP".
double column(const std::string& name, const image::Picture& picture, const view::View& view,
              const Settings& settings = {}) {
    ColumnChoice choice;
    choice.names = {name};
    Requirements requirements;
    const Column column = choose_columns(choice, settings, requirements).at(0);
    image::Picture copy = picture;
    return column.value(measure(read(make_plan({settings, requirements}), copy, "test", view)));
}

}  // namespace

// A dome of constant luminance L gives Ev = pi L, mean L, and no contrast.  The rim is cut to whole pixels: 1e-4.
TEST_CASE("a uniform dome") {
    const int n = 256;
    image::Picture p = picture(n, n, std::vector<double>(size_t(n) * n, 1000));
    CHECK(column("Ev", p, fisheye()) == doctest::Approx(1000 * pi).epsilon(1e-4));
    CHECK(column("UGR", p, fisheye()) == 0);
    const Measurement m = measure(read(make_plan({{}, require::sources | require::rammg}), p, "dome", fisheye()));
    CHECK(m.ev == doctest::Approx(1000 * pi).epsilon(1e-4));
    CHECK(m.omega == doctest::Approx(2 * pi).epsilon(1e-4));
    CHECK(m.mean_lum == doctest::Approx(1000).epsilon(1e-6));
    CHECK(m.rammg == doctest::Approx(0).epsilon(1e-6));
    CHECK(m.sources.empty());
    CHECK(m.dgp == doctest::Approx(5.87e-5 * m.ev + 0.159).epsilon(1e-9));
}

// A disc of luminance L and half angle r, t off the line of sight, before a dome of luminance 1: Edir = L pi sin^2 r
// cos t, CIE's veil is 10 Edir / t^2 (t in degrees), UGR = 8 log10(.25 / 1 L^2 omega / P^2).  Pixels of .3 degrees: 1
// %.
TEST_CASE("one source of glare") {
    constexpr int n = 600;
    const double degree = pi / 180, L = 1e5, r = 3 * degree, t = 30 * degree;
    std::vector<double> cdm2;
    for (int y = 0; y < n; y++) {
        for (int x = 0; x < n; x++) {
            const double right = (x + .5) / n * 2 - 1, up = (y + .5) / n * 2 - 1, off = std::hypot(right, up);
            const double angle = off * pi / 2,
                         cosine = std::sin(angle) * right / off * std::sin(t) + std::cos(angle) * std::cos(t);
            cdm2.push_back(off > 1 ? 0 : cosine > std::cos(r) ? L : 1);
        }
    }
    const image::Picture p = picture(n, n, cdm2);
    const double direct = L * pi * std::pow(std::sin(r), 2) * std::cos(t), veil = 10 * direct / 900;
    CHECK(column("n_sources", p, fisheye()) == 1);
    CHECK(column("Edir", p, fisheye()) == doctest::Approx(direct).epsilon(.01));
    CHECK(column("LveilCIE", p, fisheye()) == doctest::Approx(veil).epsilon(.01));
    const double P = position_index(view::Projector(fisheye()), {std::sin(t), std::cos(t), 0});
    const double omega = 2 * pi * (1 - std::cos(r));
    CHECK(column("UGR", p, fisheye()) == doctest::Approx(8 * std::log10(.25 * L * L * omega / (P * P))).epsilon(.01));
    Settings settings;  // terms up to this do not count
    settings.formulas.veil_cut = 1.1 * veil;
    CHECK(column("LveilCIE", p, fisheye(), settings) == 0);
}

TEST_CASE("RAMMG by hand") {
    std::vector<double> inner(16, 0), corner(16, 0), point(64, 0), checker(64), ramp(64), odd(42);
    inner[5] = 1;
    corner[0] = 1;
    point[2 * 8 + 3] = 1;
    for (int i = 0; i < 64; ++i) checker[i] = (i / 8 + i % 8) % 2, ramp[i] = i % 8;
    for (int i = 0; i < 42; ++i) odd[i] = ((i / 6) * (i % 6)) % 5;
    CHECK(rect_rammg(4, 4, inner) == doctest::Approx(0.015625).epsilon(1e-6));  // 2/(8 * 16)
    CHECK(rect_rammg(4, 4, corner) == doctest::Approx(0.006194478271980).epsilon(1e-6));
    CHECK(rect_rammg(8, 8, point) == doctest::Approx(0.00390625).epsilon(1e-6));  // two equal levels
    CHECK(rect_rammg(8, 8, checker) == doctest::Approx(0.032035195807721).epsilon(1e-6));
    CHECK(rect_rammg(8, 8, ramp) == doctest::Approx(0.092421494440224).epsilon(1e-6));
    CHECK(rect_rammg(6, 7, odd) == doctest::Approx(0.107741620427176).epsilon(1e-6));
    CHECK(std::isnan(rect_rammg(2, 8, std::vector<double>(16, 1))));
}

TEST_CASE("position index is 1 on the line of sight and meets itself on the horizontal") {
    const view::Projector p(fisheye());
    CHECK(position_index(p, {0, 1, 0}) == doctest::Approx(1));
    const double s = std::sin(pi / 6), c = std::cos(pi / 6);
    CHECK(position_index(p, {s, c, 0}) == doctest::Approx(1.46814).epsilon(1e-5));
    CHECK(position_index(p, {s, c, -1e-9}) == doctest::Approx(1.46770).epsilon(1e-5));
    CHECK(position_index(p, {0, 0, 1}) == 16);  // straight up: the cap
    view::View tilted = fisheye();
    tilted.vd = {.2, 1, -.3};
    for (const view::Projector& q : {p, view::Projector(tilted)})
        for (double X = .03; X < 1; X += .0431)
            for (double Y = .02; Y < 1; Y += .0377)
                if (auto d = q.direction(X, Y); d && dot(*d, q.forward()) > 1e-3)
                    CHECK(log_position_index(q, *d) == doctest::Approx(std::log(position_index(q, *d))).epsilon(1e-6));
}

// Four pixels side by side, blocks of 256, and what is left over; in the memory of the colours, too.
TEST_CASE("grey is the weighted sum of the colours, to the bit") {
    uint32_t random = 1;
    for (const size_t pixels : {1u, 3u, 4u, 7u, 255u, 259u, 1030u}) {
        std::vector<float> rgb(3 * pixels), grey(pixels), want;
        for (float& v : rgb) {
            random = random * 1664525u + 1013904223u;
            v = std::ldexp(float(random >> 8), -int(random >> 27) - 4);
        }
        std::copy_n(std::vector<float>{1, 1, -100}.begin(), 3, rgb.end() - 3);  // a negative one
        for (size_t i = 0; i < pixels; ++i)
            want.push_back(float((image::grey_red * rgb[3 * i] + image::grey_blue * rgb[3 * i + 2]) +
                                 image::grey_green * rgb[3 * i + 1]));
        const image::OddPixels odd = image::to_grey(rgb.data(), pixels, grey.data());
        CHECK(grey == want);
        CHECK(odd.negative == 1);
        image::to_grey(rgb.data(), pixels, rgb.data());
        rgb.resize(pixels);
        CHECK(rgb == want);
    }
}

TEST_CASE("not finite pixels are black and counted, negative ones only counted") {
    image::Picture p = picture(4, 4, std::vector<double>(16, 179));
    p.rgb[0] = std::numeric_limits<float>::quiet_NaN();
    p.rgb[4] = std::numeric_limits<float>::infinity();
    p.rgb[6] = p.rgb[7] = p.rgb[8] = -1;
    p.rgb[10] = 3e38f;
    const Luminance lum = make_luminance(p);
    CHECK(lum.not_finite == 3);
    CHECK(lum.negative == 1);
    CHECK(lum.grey[0] == 0);
    CHECK(lum.at(size_t(2)) == doctest::Approx(-179));
    CHECK(lum.at(size_t(4)) == doctest::Approx(179));
}

TEST_CASE("a region: coverage weighs") {
    image::Picture p = picture(2, 1, {100, 400});
    const Geometry g(*p.header.view, 2, 1);
    const Luminance lum = make_luminance(p);
    const RegionValues v = RegionPixels({1.f, .5f}, g).measure(lum);  // both pixels have one solid angle
    CHECK(v.tal == doctest::Approx((100 + 0.5 * 400) / 1.5));
    CHECK(v.share == doctest::Approx(0.75));
    CHECK(v.lowest == doctest::Approx(100));
    CHECK(v.highest == doctest::Approx(400));
    CHECK(std::isnan(RegionPixels({0.f, 0.f}, g).tal(lum)));
}

TEST_CASE("rules of tolerances") {
    const auto rule = parse_tolerances("DGP 1%, Ev 5", "-until");
    REQUIRE(rule.size() == 2);
    CHECK(rule[0].share == doctest::Approx(.01));
    CHECK(rule[0].amount == 0);
    CHECK(rule[1].amount == 5);
    CHECK(rule[1].share == 0);
    CHECK_THROWS_AS(parse_tolerances("DGP", "-until"), base::Error);
    CHECK_THROWS_AS(parse_tolerances("DGP -1%", "-until"), base::Error);
    CHECK_THROWS_AS(parse_tolerances("", "-until"), base::Error);
}

TEST_CASE("numbers for a reader have the digits that their interval leaves meaning") {
    CHECK(with_error(2805.8563, 17.18) == "2806 +- 17");
    CHECK(with_error(.35966, .0021) == "0.3597 +- 0.0021");
    CHECK(with_error(28058.563, 1234) == "28100 +- 1200");
    CHECK(with_error(-1.5, .096) == "-1.500 +- 0.096");
    CHECK(with_error(562.90149, 0) == "562.901 +- 0");
    CHECK(with_error(562.90149, std::nan("")) == "562.9");
}

TEST_CASE("tables compare metric by metric") {
    const NumberTable a{"a", {"Ev", "DGP"}, {}, {}, {{1000, 0.3}}, {}},
        b{"b", {"DGP", "Ev"}, {}, {}, {{0.3001, 1000.01}}, {}}, c{"c", {"Ev"}, {}, {}, {{1000}}, {}};
    CHECK(only(b, a.names, "a").rows[0] == std::vector<double>{1000.01, 0.3001});
    CHECK_THROWS_AS(only(c, a.names, "a"), base::Error);
    CHECK(within(tolerance_for("Ev", {}), 1000, 1000.01));       // 0.01 %
    CHECK_FALSE(within(tolerance_for("DGP", {}), 0.3, 0.3001));  // 2e-5
    CHECK(within(tolerance_for("DGP", parse_tolerances("DGP 1%", "-tolerance")), 0.3, 0.3001));
    CHECK(within(tolerance_for("DGP", {}), std::nan(""), std::nan("")));
    CHECK(pair_rows(a, b) == std::vector<size_t>{0});
}
