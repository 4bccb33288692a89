// SPDX-License-Identifier: BSD-3-Clause
// See colours.h.
#include "display/colours.h"

#include <algorithm>
#include <cmath>

namespace display {

size_t ColourTable::index(double value) const {
    return size_t(std::upper_bound(thresholds.begin(), thresholds.end(), value,
                                   [](double v, double threshold) { return !(v >= threshold); }) -
                  thresholds.begin());
}

const ColourTable& srgb_codes() {
    static const ColourTable table = [] {
        ColourTable t;
        for (int code = 0; code < 256; ++code) {
            t.colours.push_back({uint8_t(code), uint8_t(code), uint8_t(code)});
            const double v = (code - .5) / 255;  // the least encoded value that rounds to this code
            if (code > 0) t.thresholds.push_back(v <= .04045 ? v / 12.92 : std::pow((v + .055) / 1.055, 2.4));
        }
        return t;
    }();
    return table;
}

Colour ramp(double t) {
    static const double stops[][3] = {{16, 8, 40},   {44, 30, 130},  {36, 88, 180},  {20, 140, 160},
                                      {60, 178, 92}, {180, 196, 60}, {250, 190, 70}, {255, 222, 210}};
    constexpr int last = int(sizeof stops / sizeof stops[0]) - 1;
    t = t > 0 ? std::min(t, 1.0) * last : 0;  // also NaN
    const int i = std::min(int(t), last - 1);
    Colour c{};
    for (size_t k = 0; k < 3; ++k) c[k] = uint8_t(stops[i][k] + (t - i) * (stops[i + 1][k] - stops[i][k]) + .5);
    return c;
}

}  // namespace display
