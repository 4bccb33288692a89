// SPDX-License-Identifier: BSD-3-Clause
// Coverage against brute force: every pixel's centre, and many points a pixel; sets of regions; zones; masks;
// repetition.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <random>
#include <fmt/format.h>
#include "base/error.h"
#include "region/region.h"
#include "region/raster.h"
#include "image/stream.h"

using namespace base;
using region::Regions;

namespace {

view::View fisheye(double size = 180) {
    view::View v;
    v.type = 'a';
    v.vd = {.2, 1, -.1};
    v.vh = v.vv = size;
    return v;
}
std::vector<float> plane(const std::string& text, const view::View& v, int n, bool centre = false) {
    return region::rasterize(region::parse(text, "test"), v, n, n, centre).masks.back().coverage;
}
double mean(const std::vector<float>& p) {
    double s = 0;
    for (float x : p) s += x;
    return s / double(p.size());
}

// One of everything, in view of an eye at the origin that looks along y.
const char* EVERYTHING =
    "poly polygon3d -1 3 -1  .5 3 -1.2  .2 3 .1  1 3 .9  -1.1 3 .8\n"
    "disc disc3d .5 2 .5  .3 1 .2  .4\n"
    "box box3d -.9 1 -.5  -.3 1.6 .1\n"
    "ball sphere3d .8 1.2 -.6 .3\n"
    "cone circle .4 1 .2 25\n"
    "star polygon direction -.5 1 -.5  .5 1 -.4  0 1 .1  .4 1 .6  -.4 1 .5\n"
    "free polygon fraction .1 .2 .9 .3 .5 .5 .8 .9 .2 .7\n"
    "wide rect fraction .3 .1 .77 .4\n"
    "ergo zone ergorama\n"
    "band zone position 1.5 3\n"
    "total zone total\n"
    "both zone binocular\n"
    "mix1 (poly + ball) - disc\n"
    "mix2 !cone & wide + box\n"
    "mix3 star & free - !both\n";

}  // namespace

TEST_CASE("with -centre, the coarse-to-fine walk decides every pixel as its centre alone would") {
    for (char type : {'a', 'v', 'h', 's', 'c'}) {
        view::View v = fisheye(type == 'v' ? 100 : type == 'h' ? 180 : 170);
        v.type = type;
        const int n = 211;  // no power of two
        Regions r = region::parse(EVERYTHING, "test");
        image::MaskSet set = region::rasterize(r, v, n, n, true);
        region::Prepared brute(r, v, n, n);
        for (size_t m = 0; m < set.masks.size(); ++m) {
            int wrong = 0, inside = 0;
            for (int y = 0; y < n; ++y)
                for (int x = 0; x < n; ++x) {
                    region::Point p;
                    bool in = brute.space.point(x + .5, y + .5, p) && brute.value(r.regions[m].root, p, {1, 1}) >= 0;
                    bool got = set.masks[m].coverage[size_t(n - 1 - y) * n + size_t(x)] > 0;
                    wrong += in != got;
                    inside += in;
                }
            CAPTURE(type);
            CAPTURE(set.masks[m].name);
            CHECK(wrong == 0);
            CHECK(inside > 0);
        }
    }
}

TEST_CASE("coverage is the share of a pixel's area, to 1/64") {
    // Points of a rank-1 lattice (golden ratio), 16384 a pixel: off by far less than 1/64.
    view::View v = fisheye();
    const int n = 96, samples = 16384;
    Regions r = region::parse(EVERYTHING, "test");
    image::MaskSet set = region::rasterize(r, v, n, n, false);
    region::Prepared brute(r, v, n, n);
    std::mt19937 random(7);
    for (size_t m = 0; m < set.masks.size(); ++m) {
        double worst = 0;
        std::vector<int> border;
        for (int i = 0; i < n * n; ++i) {
            float c = set.masks[m].coverage[size_t(i)];
            if (c > 0 && c < 1) border.push_back(i);
        }
        REQUIRE(border.size() > 20);
        for (int k = 0; k < 12; ++k) {
            int i = border[random() % border.size()], x = i % n, y = n - 1 - i / n, in = 0;
            for (int s = 0; s < samples; ++s) {
                region::Point p;
                double fx = (s + .5) / samples, fy = std::fmod(s * 0.6180339887498949, 1);
                in += brute.space.point(x + fx, y + fy, p) && brute.value(r.regions[m].root, p, {1, 1}) >= 0;
            }
            worst = std::max(worst, std::fabs(double(in) / samples - set.masks[m].coverage[size_t(i)]));
        }
        CAPTURE(set.masks[m].name);
        CHECK(worst < 1.0 / 64);
    }
}

TEST_CASE("a thin line is not lost between the pixels' corners") {
    // 0.1 pixels wide, 80 long, at a slant.
    view::View v = fisheye();
    double c = std::cos(.3), s = std::sin(.3);
    std::string line = "a polygon";
    for (auto q : {std::pair(-40., -.05), std::pair(40., -.05), std::pair(40., .05), std::pair(-40., .05)})
        line += fmt::format(" {:.9g} {:.9g}", 50 + c * q.first - s * q.second, 50 + s * q.first + c * q.second);
    CHECK(mean(plane(line, v, 100)) * 100 * 100 == doctest::Approx(8).epsilon(.02));
}

TEST_CASE("sets obey their laws") {
    view::View v = fisheye();
    const std::string ab = "a circle 0 1 0 50\nb circle .4 1 .2 40\n";
    auto area = [&](const std::string& e) { return mean(plane(ab + "r " + e, v, 128)); };
    CHECK(area("a + b") == doctest::Approx(area("a") + area("b") - area("a & b")).epsilon(1e-4));
    CHECK(area("a - b") == doctest::Approx(area("a") - area("a & b")).epsilon(1e-4));
    CHECK(area("!(a + b)") == doctest::Approx(area("!a & !b")).epsilon(1e-9));
    CHECK(area("!!a") == doctest::Approx(area("a")).epsilon(1e-9));
    CHECK(area("a - a") < 2e-3 * area("a"));
    CHECK(area("!a") ==
          doctest::Approx(area("circle view 180") - area("a")).epsilon(1e-4));  // the view ends at 90 degrees
}

TEST_CASE("zones: cones around the line of sight, bands of the position index") {
    view::View v = fisheye();
    CHECK(plane("a zone central", v, 100) == plane("a circle view 30", v, 100));
    CHECK(plane("a zone ergorama", v, 100) == plane("a circle view 60", v, 100));
    CHECK(plane("a zone panorama", v, 100) == plane("a circle view 120", v, 100));
    // Bands tile the half sphere.
    double parts = 0;
    for (const char* band : {"0 1.5", "1.5 3", "3 8", "8 100"})
        parts += mean(plane(std::string("a zone position ") + band, v, 128));
    CHECK(parts == doctest::Approx(mean(plane("a circle view 180", v, 128))).epsilon(1e-3));
    // Straight up, sigma = 30 degrees: P = exp(33.98e-3 * 30 + 21e-5 * 900) = 3.348
    auto up = plane("a zone position 3.3 3.4", v, 720, true);
    int row = 719 - (360 + 120);  // 4 pixels a degree
    CHECK(up[size_t(row) * 720 + 360] == 1);
    CHECK(up[size_t(row + 12) * 720 + 360] == 0);
}

TEST_CASE("behind the eye and edge on there is nothing") {
    view::View v = fisheye(90);
    CHECK(mean(plane("a polygon3d -1 -3 -1  1 -3 -1  1 -3 1  -1 -3 1", v, 64)) == 0);
    CHECK(mean(plane("a polygon3d 0 1 -1  0 3 -1  0 3 1  0 1 1", v, 64)) == 0);
    CHECK(mean(plane("a sphere3d 0 0 0 1", v, 64)) > .99);  // the eye within
    CHECK(mean(plane("a box3d -1 -1 -1 1 1 1", v, 64)) > .99);
}

TEST_CASE("holes by seams, as RADIANCE cuts them") {
    view::View v = fisheye(90);
    const char* frame =
        "a polygon3d -1 2 -1  1 2 -1  1 2 1  -1 2 1  -1 2 -1  -.5 2 -.5  -.5 2 .5  .5 2 .5  .5 2 -.5  -.5 2 -.5\n";
    const char* parts =
        "b polygon3d -1 2 -1  1 2 -1  1 2 1  -1 2 1\nc polygon3d -.5 2 -.5  .5 2 -.5  .5 2 .5  -.5 2 .5\na b - c\n";
    CHECK(mean(plane(frame, v, 100)) == doctest::Approx(mean(plane(parts, v, 100))).epsilon(1e-4));
}

TEST_CASE("bad geometry is an error at its line") {
    view::View v = fisheye();
    CHECK_THROWS_WITH(plane("\na polygon3d 0 1 0 1 1 0 1 1.2 1 0 1 1", v, 64),
                      doctest::Contains("test:2: the polygon is not flat"));
    CHECK_THROWS_WITH(plane("a polygon3d 0 1 0 1 1 0 2 1 0", v, 64), doctest::Contains("no area"));
    CHECK_THROWS_WITH(plane("a circle 64 3 30", v, 64),
                      doctest::Contains("test:1: the circle's centre is not in the picture"));
    CHECK_THROWS_WITH(plane("a polygon direction 0 1 0 0 -1 .1 1 0 0 -1 0 0", v, 64), doctest::Contains("hemisphere"));
    CHECK_THROWS_WITH(plane("a surface x", v, 64), doctest::Contains("no scene is given"));
    CHECK_THROWS_WITH(plane("a mask nothere.hdr", v, 64), doctest::Contains("test:1: "));
    CHECK_THROWS_WITH(plane("a mask nothere.png", v, 64), doctest::Contains("test:1: "));
    const unsigned char large[] = {0x89, 'P',  'N',  'G',  13,   10, 26, 10,   0,    0,   0,   13,   'I',  'H', 'D',
                                   'R',  0,    0,    0x3e, 0x80, 0,  0,  0x3e, 0x80, 8,   0,   0,    0,    0,   0x64,
                                   0x15, 0x80, 0x02, 0,    0,    0,  0,  'I',  'D',  'A', 'T', 0x35, 0xaf, 6,   0x1e};
    std::ofstream("large.png", std::ios::binary).write(reinterpret_cast<const char*>(large), sizeof large);
    CHECK_THROWS_WITH(plane("a mask large.png", v, 64),
                      doctest::Contains("test:1: mask large.png is too short for its 16000 x 16000 pixels"));
    std::remove("large.png");
    const unsigned char chunk[] = {0x89, 'P',  'N',  'G',  13,   10,   26, 10, 0,  0,   0,   13,  'I', 'H',
                                   'D',  'R',  0,    0,    0,    1,    0,  0,  0,  1,   8,   0,   0,   0,
                                   0,    0x3a, 0x7e, 0x9b, 0x55, 0x1c, 0,  0,  14, 't', 'E', 'X', 't'};
    std::ofstream("chunk.png", std::ios::binary).write(reinterpret_cast<const char*>(chunk), sizeof chunk);
    CHECK_THROWS_WITH(plane("a mask chunk.png", v, 64),
                      doctest::Contains("test:1: mask chunk.png: a chunk of 469762062 bytes, where 0 are left"));
    std::remove("chunk.png");
}

TEST_CASE("mask pictures: their grey alone, in or out at one half in sets, any size") {
    image::Picture p;
    p.width = p.height = 4;
    p.rgb.assign(48, 0.f);
    for (int c = 0; c < 3; ++c) p.at(1, 0)[c] = 1, p.at(2, 3)[c] = .25f, p.at(3, 3)[c] = .75f;
    const std::string name = fmt::format(
        "{}/region_mask_{}.exr", std::getenv("TMPDIR") ? std::getenv("TMPDIR") : "/tmp", std::random_device()());
    image::write_file(name, p);
    view::View v;
    auto alone = plane("a mask " + name, v, 4);
    CHECK(alone[1] == doctest::Approx(1));
    CHECK(alone[14] == doctest::Approx(.25));
    CHECK(plane("a mask " + name, v, 2)[3] == doctest::Approx(.25));  // mean of 0 0 .25 .75
    auto fine = plane("a mask " + name, v, 16);
    CHECK(fine[4] == doctest::Approx(1));
    auto set = plane("b rect 0 0 100 100\na b & mask " + name, v, 4);
    CHECK(set[14] == 0);
    CHECK(set[15] == 1);
    CHECK(set[1] == 1);
    CHECK(mean(set) == doctest::Approx(2. / 16));
    auto outside = plane("a !mask " + name, v, 8);
    CHECK(mean(outside) == doctest::Approx(14. / 16));
    std::remove(name.c_str());
}

TEST_CASE("the same bytes on every run, and small or empty regions are told") {
    Regions r = region::parse(EVERYTHING, "test");
    auto a = region::rasterize(r, fisheye(), 150, 130, false), b = region::rasterize(r, fisheye(), 150, 130, false);
    for (size_t m = 0; m < a.masks.size(); ++m) CHECK(a.masks[m].coverage == b.masks[m].coverage);
    Regions none = region::parse("a circle 0 1 0 9\nb circle 0 -1 0 10\n", "test");
    view::View v;
    auto set = region::rasterize(none, v, 64, 64, false);
    CHECK_THROWS_WITH(region::check_sizes(none, region::measure(set, v)),
                      doctest::Contains("test:2: region \"b\" is empty"));
    auto quick = region::count_pixels(set, v), full = region::measure(set, v);
    CHECK(quick[0].pixels == doctest::Approx(full[0].pixels).epsilon(1e-9));
    CHECK(full[0].share > 0);
    CHECK(full[0].centre.y == doctest::Approx(1).epsilon(1e-6));
}
