// SPDX-License-Identifier: BSD-3-Clause
// Pictures for tests of comfort metrics: grey, from luminances, seen through an angular fisheye lens.
#pragma once
#include <vector>

#include "glare/luminance.h"
#include "image/picture.h"

inline image::Picture fisheye_of(const std::vector<double>& cdm2, int width, double field_deg = 180) {
    image::Picture p;
    p.width = width;
    p.height = int(cdm2.size()) / width;
    for (double v : cdm2)
        for (int c = 0; c < 3; ++c) p.rgb.push_back(float(v / glare::cdm2_per_grey));
    view::View v;
    v.type = 'a';
    v.vh = v.vv = field_deg;
    p.header.view = v;
    return p;
}

// L'(n) of a stream, as ptaccum writes it.
inline void as_sum(image::Picture& p, int64_t n) {
    p.floats = true;
    p.header.frames = n, p.header.ranges = {{0, n}};
}
