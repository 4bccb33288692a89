// SPDX-License-Identifier: BSD-3-Clause
// Tables from a value to a colour of 8 bits a channel.  A table is thresholds and colours, nothing else, so that
// another program (the live page) that is given its numbers shows the same bytes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace display {

using Colour = std::array<uint8_t, 3>;
constexpr Colour black{0, 0, 0};

// colours[k] for values from thresholds[k - 1] up to, not including, thresholds[k]; the first also for NaN.
struct ColourTable {
    std::vector<double> thresholds;  // rising
    std::vector<Colour> colours;     // one more than thresholds
    size_t index(double value) const;
    Colour at(double value) const { return colours[index(value)]; }
};

// sRGB (IEC 61966-2-1) codes 0 to 255 of display values 0 to 1, as greys.
const ColourTable& srgb_codes();

// The colour ramp, t in [0,1]: dark violet, blue, teal, green, yellow, orange, pale red; lightness rises throughout.
Colour ramp(double t);

}  // namespace display
