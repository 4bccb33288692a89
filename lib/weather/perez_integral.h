// SPDX-License-Identifier: BSD-3-Clause
// Horizontal irradiance of a Perez sky as perezlum.cal renders it: (weight sky + ground)/(weight + 1), with the cosine
// of the gradation bounded below.
#pragma once
#include "generators/perez.h"

namespace weather {

constexpr double lowest_cosine = .01;

// (z + 1.01)^20: how much more of the sky than of the ground there is at this height over the horizon.
inline double horizon_weight(double z) {
    const double x = z + 1.01, x2 = x * x, x4 = x2 * x2, x8 = x4 * x4;
    return x8 * x8 * x4;
}

// Of the upper hemisphere: of a sky of level 1, and of a ground of radiance 1.
struct PerezIntegral {
    double sky = 0, ground = 0;
};
// To a few millionths.
PerezIntegral integrate(const generators::PerezShape& shape, double sun_zenith_angle);

}  // namespace weather
