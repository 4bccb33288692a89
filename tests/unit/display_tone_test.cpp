// SPDX-License-Identifier: BSD-3-Clause
// Pictures for people: tone curves, falsecolor and its tables, what is drawn on pictures, PNG.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "display/draw.h"
#include "display/file.h"
#include "display/outline.h"

TEST_CASE("tone curves: order is kept, the middle is visible, the legend is beside the picture") {
    image::Picture p;
    p.width = 256;
    p.height = 64;
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 256; ++x)
            for (int c = 0; c < 3; ++c) p.rgb.push_back(float(std::pow(10, x / 64. - 2)));  // four decades
    const display::Image8 photo = display::tone(p, {});
    for (int x = 1; x < 256; ++x) CHECK(photo.at(x, 0)[1] >= photo.at(x - 1, 0)[1]);
    CHECK(photo.at(0, 0)[1] < 60);
    CHECK(photo.at(128, 0)[1] > 60);
    CHECK(photo.at(128, 0)[1] < 200);
    CHECK(photo.at(255, 0)[1] > 240);
    display::ToneOptions o;
    o.kind = display::ToneOptions::Kind::falsecolor;
    o.max_cdm2 = 17900;
    o.decades = 4;
    const display::Image8 colors = display::falsecolor(p, o);
    CHECK(colors.width > 256);
    CHECK(colors.height == 64);
    // x = 192 is radiance 10 = 1790 cd/m2: one decade below the top of four
    const auto want = display::ramp(.75);
    for (size_t c = 0; c < 3; ++c) CHECK(std::abs(colors.at(192, 5)[c] - want[c]) <= 2);
    const std::string png = display::png_bytes(colors, "header");
    CHECK(png.substr(1, 3) == "PNG");
    image::Picture black;
    black.width = black.height = 2;
    black.rgb.assign(12, 0);
    CHECK(display::tone(black, {}).rgb == std::vector<uint8_t>(12, 0));
    CHECK(display::falsecolor(black, o).rgb.size() > 0);
}

TEST_CASE("the colour ramp's lightness rises throughout") {
    double last = -1;
    for (int i = 0; i <= 70; ++i) {
        const auto c = display::ramp(i / 70.);
        const double light = .2126 * std::pow(c[0] / 255., 2.2) + .7152 * std::pow(c[1] / 255., 2.2) +
                             .0722 * std::pow(c[2] / 255., 2.2);
        CHECK(light > last);
        last = light;
    }
    CHECK(display::round_up_125(1900) == 2000);
    CHECK(display::round_up_125(2000) == 2000);
    CHECK(display::round_up_125(5001) == 10000);
    CHECK(display::round_up_125(.013) == doctest::Approx(.02));
}

namespace {
// A row of greys whose luminances are these.
image::Picture row(const std::vector<double>& luminances) {
    image::Picture p;
    p.width = int(luminances.size());
    p.height = 1;
    for (const double l : luminances) p.rgb.insert(p.rgb.end(), 3, float(l / image::lumens_per_watt));
    return p;
}
}  // namespace

TEST_CASE("the table of sRGB codes rounds as the formula does") {
    for (int i = 0; i <= 4000; ++i) {
        const double v = i / 4000.;
        const double coded = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
        const double off = coded * 255 - display::srgb_codes().at(v)[0];
        CHECK(std::fabs(off) <= .5001);
    }
    CHECK(display::srgb_codes().at(-1)[0] == 0);
    CHECK(display::srgb_codes().at(std::nan(""))[0] == 0);
    CHECK(display::srgb_codes().at(1e30)[0] == 255);
}

TEST_CASE("bands divide the scale evenly, and a mask makes black what is below it") {
    display::ToneOptions o;
    o.kind = display::ToneOptions::Kind::falsecolor;
    o.style = display::ToneOptions::Style::bands;
    o.max_cdm2 = 1000;
    o.decades = 0;
    o.divisions = 4;
    o.legend = false;
    const auto colour = [&](double l) {
        const display::Image8 shown = display::falsecolor(row({l}), o);
        return display::Colour{shown.rgb[0], shown.rgb[1], shown.rgb[2]};
    };
    CHECK(colour(10) == display::ramp(0));
    CHECK(colour(240) == display::ramp(0));
    CHECK(colour(260) == display::ramp(1 / 3.));
    CHECK(colour(740) == display::ramp(2 / 3.));
    CHECK(colour(5000) == display::ramp(1));
    o.mask_cdm2 = 300;
    CHECK(colour(290) == display::Colour{});
    CHECK(colour(310) == display::ramp(1 / 3.));
    o.decades = 2;  // bands from 10 to 1000: 10, 31.6, 100, 316, 1000
    o.mask_cdm2 = 0;
    CHECK(colour(31) == display::ramp(0));
    CHECK(colour(33) == display::ramp(1 / 3.));
    CHECK(colour(320) == display::ramp(1));
}

TEST_CASE("contours are drawn where the band changes, and nowhere else") {
    display::ToneOptions o;
    o.kind = display::ToneOptions::Kind::falsecolor;
    o.style = display::ToneOptions::Style::contours;
    o.max_cdm2 = 100;
    o.decades = 0;
    o.divisions = 2;
    o.legend = false;
    const display::Image8 shown = display::falsecolor(row({10, 20, 60, 70}), o);
    const auto is_grey = [&](int x) { return shown.at(x, 0)[0] == shown.at(x, 0)[1]; };
    CHECK(is_grey(0));
    CHECK_FALSE(is_grey(1));
    CHECK(is_grey(2));
    CHECK(is_grey(3));
}

TEST_CASE("an area has its outline in its colour and its inside tinted") {
    display::Image8 picture{5, 5, std::vector<uint8_t>(75, 100)};
    std::vector<float> coverage(25, 0);
    for (int y = 1; y < 4; ++y)
        for (int x = 1; x < 4; ++x) coverage[size_t(5 * y + x)] = 1;
    display::draw_area(picture, coverage, {200, 0, 0}, .5);
    CHECK(picture.at(0, 0)[0] == 100);
    CHECK(picture.at(1, 1)[0] == 200);
    CHECK(picture.at(2, 2)[0] == 150);
    CHECK(display::with_labels(picture, {{"desk"}}).height > 5);
}

TEST_CASE("outlines: closed, around what they must hold, cut where coverage is a half") {
    const auto area = [](const display::Ring& r) {
        double sum = 0;
        for (size_t k = 0; k < r.size(); ++k) {
            const auto &a = r[k], &b = r[(k + 1) % r.size()];
            sum += double(a[0]) * b[1] - double(b[0]) * a[1];
        }
        return sum / 2;
    };
    CHECK(display::outlines(std::vector<float>(12, 0), 4, 3).empty());
    // the whole picture, up to its border
    const auto all = display::outlines(std::vector<float>(12, 1), 4, 3);
    REQUIRE(all.size() == 1);
    CHECK(std::fabs(area(all[0])) == doctest::Approx(12 - 4 * .125));  // four corners are cut
    // a ring: its hole turns the other way
    std::vector<float> ring(49, 1);
    for (int y = 2; y < 5; ++y)
        for (int x = 2; x < 5; ++x) ring[size_t(7 * y + x)] = 0;
    const auto two = display::outlines(ring, 7, 7);
    REQUIRE(two.size() == 2);
    CHECK(area(two[0]) * area(two[1]) < 0);
    CHECK(std::fabs(area(two[0]) + area(two[1])) == doctest::Approx(49 - .5 - (9 - .5)));
    // two pixels that touch at a corner stay apart; random sets give closed rings around as many pixels as they hold
    CHECK(display::outlines({1, 0, 0, 1}, 2, 2).size() == 1);
    CHECK(display::outlines({.8f, 0, 0, .8f}, 2, 2).size() == 2);
    std::minstd_rand random(3);
    for (int trial = 0; trial < 200; ++trial) {
        std::vector<float> set(35);
        double pixels = 0;
        for (float& v : set) pixels += v = float(random() % 2);
        double sum = 0;
        for (const display::Ring& r : display::outlines(set, 7, 5)) {
            CHECK(r.size() >= 3);
            sum += area(r);
        }
        CHECK(std::fabs(std::fabs(sum) - pixels) <= 35 * .5);
    }
}
