// SPDX-License-Identifier: BSD-3-Clause
// RGBE byte by byte: steps, extremes, and run-lengths typed by hand.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>

#include "image/header.h"
#include "image/rgbe.h"
#include "image/stream.h"
#include "image_bytes.h"
#include "image_pictures.h"
#include "temp_folder.h"

using image::Format;
using image::Picture;
using image::StreamReader;

TEST_CASE("RGBE pixels: half a step is added, E = 0 is black") {
    const Picture p = read(rgbe_head + "-Y 1 +X 2\n" +
                           std::string("\x80\x40\x00\x81"
                                       "\xff\xff\xff\x00",
                                       8));
    CHECK(p.rgb == std::vector<float>{decoded(128, 129), decoded(64, 129), decoded(0, 129), 0, 0, 0});
}

TEST_CASE("RGBE keeps values within its step, makes negative ones 0 and survives the extremes") {
    const int n = 40;
    std::vector<float> rgb;
    for (int i = 0; i < 3 * n; ++i) rgb.push_back(float(std::pow(10., -20 + i / 3) * (1 + i % 3)));
    std::vector<uint8_t> row(4 * n);
    std::vector<float> back(3 * n);
    image::float_to_rgbe(rgb.data(), n, row.data());
    image::rgbe_to_float(row.data(), n, back.data());
    for (int i = 0; i < 3 * n; ++i) {
        const float step = rgb[size_t(i / 3 * 3 + 2)] / 128;  // of the largest channel, at most
        CHECK(std::fabs(back[size_t(i)] - rgb[size_t(i)]) <= step);
    }
    const float odd[9] = {-1, 2, NAN, INFINITY, 1, 1, 3e38f, 0, 1e-33f};
    image::float_to_rgbe(odd, 3, row.data());
    image::rgbe_to_float(row.data(), 3, back.data());
    CHECK(row[0] == 0);
    CHECK(row[2] == 0);
    CHECK(back[1] == doctest::Approx(2).epsilon(.01));
    CHECK(back[3] > 1e38f);
    CHECK(back[6] > 1e38f);
}

TEST_CASE("rounding down and adding half is unbiased") {
    // 1000 values evenly in [1,2) are steps of 1/128 wide: the mean error of (floor + .5) is below a tenth of a step.
    double error = 0;
    for (int i = 0; i < 1000; ++i) {
        const float v = 1 + float(i) / 1000, rgb[3] = {v, v, v};
        uint8_t row[4];
        float back[3];
        image::float_to_rgbe(rgb, 1, row);
        image::rgbe_to_float(row, 1, back);
        error += back[0] - v;
    }
    CHECK(std::fabs(error / 1000) < .1 / 128);
}

TEST_CASE("new run-length, typed by hand") {
    // 2 2 0 9; red: run of 9 x 128; green: 9 literals; blue: 4 literals, run of 5; exponent: run of 9 x 129
    const std::string line(
        "\x02\x02\x00\x09"
        "\x89\x80"
        "\x09\x01\x02\x03\x04\x05\x06\x07\x08\x09"
        "\x04\x0a\x0b\x0c\x0d\x85\x0e"
        "\x89\x81",
        25);
    const Picture p = read(rgbe_head + "-Y 1 +X 9\n" + line);
    CHECK(p.at(0, 0)[0] == decoded(128, 129));
    CHECK(p.at(8, 0)[1] == decoded(9, 129));
    CHECK(p.at(3, 0)[2] == decoded(13, 129));
    CHECK(p.at(8, 0)[2] == decoded(14, 129));
    CHECK(why(rgbe_head + "-Y 1 +X 8\n" + line) == "scanline length 9 does not match width 8");
    CHECK(why(rgbe_head + "-Y 1 +X 9\n" + line.substr(0, 4) + "\x8a\x80" + line.substr(6)) ==
          "a run is longer than the scanline");
    CHECK(why(rgbe_head + "-Y 1 +X 9\n" + line.substr(0, 4) + std::string("\x00\x80", 2) + line.substr(6)) ==
          "a run of no length");
}

TEST_CASE("old run-length, typed by hand: counts of markers in a row are digits of base 256") {
    std::string line(
        "\x80\x10\x20\x81"
        "\x01\x01\x01\x03"
        "\x81\x11\x21\x81"
        "\x01\x01\x01\x02\x01\x01\x01\x01",
        20);
    const int width = 1 + 3 + 1 + 2 + 256;
    const std::string head = rgbe_head + "-Y 1 +X " + std::to_string(width) + "\n";
    const Picture p = read(head + line);
    CHECK(p.at(3, 0)[0] == decoded(128, 129));
    CHECK(p.at(4, 0)[0] == decoded(129, 129));
    CHECK(p.at(width - 1, 0)[2] == decoded(33, 129));
    CHECK(why(rgbe_head + "-Y 1 +X 6\n" + line) == "a run is longer than the scanline");
    CHECK(why(rgbe_head + "-Y 1 +X 5\n" + line.substr(4)) == "a run without a pixel before it");
}

TEST_CASE("what is written run-length is what is read, for every kind of run") {
    for (const int width : {1, 7, 8, 16, 17, 127, 128, 129, 130, 260, 1000}) {
        std::string out;
        std::vector<uint8_t> row;
        for (int x = 0; x < width; ++x)
            for (int c = 0; c < 4; ++c)  // runs of 1, 3, 4 and everything; exponents above 0
                row.push_back(uint8_t(c == 0 ? x : c == 1 ? x / 3 * 5 : c == 2 ? (x / 4) % 3 ? 9 : x : 140));
        for (size_t i = 0; i < row.size(); i += 4) row[i] |= 128;  // a real RGBE pixel has a byte from 128
        image::append_rgbe_row(out, row.data(), width);
        if (width >= 130) CHECK(out.size() < row.size());
        TempFolder temp;
        image::Input in(temp.holding("row", out));
        std::vector<uint8_t> back(row.size());
        image::read_rgbe_row(in, width, back.data(), "row");
        CHECK(back == row);
        CHECK(in.at_end());
    }
}
