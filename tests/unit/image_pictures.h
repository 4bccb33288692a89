// SPDX-License-Identifier: BSD-3-Clause
// A small picture with a full header for the tests of lib/image.
#pragma once
#include "image/picture.h"

// Moments that differ in each pixel.
inline image::Moments moments_of(const image::Picture& p, float first = 1) {
    std::vector<float> all;
    for (int i = 0; i < p.width * p.height; ++i)
        all.insert(all.end(), {first + float(i), -.5f * float(i), .25f, -1.f / float(i + 2)});
    return std::make_shared<const std::vector<float>>(all);
}

// Smooth, positive and negative values over many decades; every pixel differs.
inline image::Picture small_picture(int width, int height) {
    image::Picture p;
    p.width = width;
    p.height = height;
    for (int i = 0; i < 3 * width * height; ++i) p.rgb.push_back(float((i % 7 == 3 ? -1 : 1) * (0.001 + i * i * 0.37)));
    view::View v;
    v.type = 'a';
    v.vh = v.vv = 180;
    v.vp = {1, 2, 0.1};
    p.header.view = v;
    p.header.lines = {"ptrace -x 5 scene.rad", "\tan input's line"};
    p.header.seed = 18446744073709551615u;
    p.header.frames = 9;
    p.header.ranges = {{0, 4}, {7, 11}};
    return p;
}
