// SPDX-License-Identifier: BSD-3-Clause
// What is summed over the pixels of a glare source, and the same of stretches that all swayed pictures show.
#pragma once
#include "comfort/geometry.h"
#include "comfort/swayed.h"

namespace comfort {

// SourceSums of grey times omega, that times x and y, and grey times omega cos.
struct SourceSum {
    double power = 0, x = 0, y = 0, eye = 0;
    void add(double grey, double omega, double omega_cos, double at_x, double at_y) {
        const double p = grey * omega;
        power += p, x += p * at_x, y += p * at_y, eye += grey * omega_cos;
    }
    void add(const SourceSum& more, double factor = 1) {
        power += factor * more.power, x += factor * more.x, y += factor * more.y, eye += factor * more.eye;
    }
};

// Of stretches that all pictures show: the mean, and the middle of each pixel's two values.
struct CommonSums {
    double omega = 0;
    SourceSum mean, own;
};
// Adds pixels of one row, and by word (Signs::words of them) how far their two values lie off the middle.
void add_stretch(const Swayed& lum, const Geometry& geometry, uint32_t start, uint32_t length, CommonSums& to,
                 SourceSum* off);

}  // namespace comfort
