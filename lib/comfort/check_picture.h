// SPDX-License-Identifier: BSD-3-Clause
// evalglare's check picture (its -c), for -like evalglare.  It paints tasks (-T), sources and zones in
// colours of the same luminance, in float, whether or not that picture is asked for, and reads luminances back from
// what it painted. So a pixel that moves from a source to a zone is not exactly the pixel that was added to the source:
// sums over thousands of pixels differ at 1e-8, and with them the pixel that a centre falls into. Seen by running
// evalglare: colours in the picture that -c writes, and luminances printed of 1156 single pixels.
#pragma once
#include <cstdint>
#include <vector>
#include "comfort/luminance.h"

namespace comfort {

// Shares of the luminance that red, green and blue give.
struct Paint {
    double red, green, blue;
};

constexpr Paint task_paint{0, 0, 1};
constexpr Paint zone_paint[] = {{0.66, 0.01, 0.33}, {0.65, 0.33, 0.02}};  // inner, outer
Paint source_paint(uint32_t group);                                       // five colours in turn

class CheckPicture {
public:
    explicit CheckPicture(const Luminance& lum);
    double at(size_t pixel) const { return 179 * grey_[pixel]; }
    void paint(size_t pixel, const Paint& paint);

private:
    std::vector<double> grey_;
};

}  // namespace comfort
