// SPDX-License-Identifier: BSD-3-Clause
// A small picture with a full header for the tests of lib/image.
#pragma once
#include "image/picture.h"

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
