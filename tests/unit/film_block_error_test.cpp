// SPDX-License-Identifier: BSD-3-Clause
// The estimated error of blocks against errors that are known.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <random>

#include "film/block_error.h"

namespace {

image::Picture grey_picture(int width, int height) {
    image::Picture p;
    p.width = width;
    p.height = height;
    p.rgb.assign(size_t(width) * size_t(height) * 3, 0);
    return p;
}

image::Picture noise(int width, int height, double mean, double deviation, std::mt19937& random) {
    image::Picture p = grey_picture(width, height);
    std::normal_distribution<float> value{float(mean), float(deviation)};
    for (size_t i = 0; i < p.rgb.size(); i += 3) p.rgb[i] = p.rgb[i + 1] = p.rgb[i + 2] = value(random);
    return p;
}

}  // namespace

constexpr double one_block = .8 / (4 * 8 * 4);  // deviation .8 of 4, 64 pixels, 16 frames

TEST_CASE("the error of blocks is that of the noise put in, also with blocks cut off at the edges") {
    std::mt19937 random(7);
    image::Picture direct = grey_picture(100, 60);
    for (float& v : direct.rgb) v = 3;
    film::BlockError error;
    error.restart(direct);
    error.add(noise(100, 60, 1, .8, random));
    CHECK(std::isinf(error.relative()));
    for (int k = 2; k <= 16; ++k) error.add(noise(100, 60, 1, .8, random));
    CHECK(error.relative() > .9 * one_block);
    CHECK(error.relative() < 1.3 * one_block);

    error.restart(direct);  // again, with a block of 104 that few paths light
    for (int k = 1; k <= 16; ++k) {
        image::Picture frame = noise(100, 60, 1, .8, random);
        if (k == 3) frame.rgb[0] = 1e6f;
        error.add(frame);
    }
    CHECK(error.relative() < 1.3 * one_block);
}

TEST_CASE("few frames of few blocks tell nothing") {
    std::mt19937 random(7);
    film::BlockError error;
    error.restart(noise(8, 8, 1, 0, random));
    for (int k = 1; k <= 30; ++k) error.add(noise(8, 8, 1, .8, random));
    CHECK(std::isinf(error.relative()));
    error.add(noise(8, 8, 1, .8, random));
    CHECK(error.relative() < .05);
}

TEST_CASE("a black picture has no error; frames without frame 0 have that of their mean") {
    film::BlockError black;
    black.restart(grey_picture(64, 64));
    for (int k = 1; k <= 2; ++k) black.add(grey_picture(64, 64));
    CHECK(black.relative() == 0);

    std::mt19937 random(7);
    film::BlockError partial;
    for (int k = 5; k <= 8; ++k) partial.add(noise(64, 64, 1, .8, random));
    CHECK(partial.relative() == doctest::Approx(.8 / 16).epsilon(.15));
}
