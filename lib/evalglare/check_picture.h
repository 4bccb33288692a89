// SPDX-License-Identifier: BSD-3-Clause
// The check picture (-c): grey, with tasks (-T), sources and zones in colours of the same luminance.
// evalglare always paints it, in float, and reads luminances back from the painted pixels. So a
// pixel that moves from a source to a zone is not exactly the pixel that was added to the source: sums over thousands
// of pixels differ at 1e-8, and with them the pixel that a centre falls into. Seen by running evalglare: colours in the
// picture that -c writes, and luminances printed of 1156 single pixels.
#pragma once
#include <cstdint>
#include <vector>
#include "evalglare/settings.h"
#include "glare/measure.h"

namespace evalglare {

constexpr Paint zone_paint[] = {{0.66, 0.01, 0.33}, {0.65, 0.33, 0.02}};  // inner, outer

class CheckPicture {
public:
    CheckPicture(const glare::Luminance& lum, bool to_be_seen);
    double grey(size_t pixel) const { return grey_[pixel]; }
    double at(size_t pixel) const { return 179 * grey_[pixel]; }
    void paint(size_t pixel, const Paint& paint);
    const std::vector<float>& rgb() const { return rgb_; }  // as pictures have it; empty unless to be seen

private:
    std::vector<double> grey_;
    std::vector<float> rgb_;
};

void paint_task(CheckPicture& check, const glare::Geometry& geometry, const glare::Circle& task);
void paint_sources(CheckPicture& check, const std::vector<glare::Run>& runs, const Settings& settings);
void paint_band(CheckPicture& check, const std::vector<uint32_t>& pixels);

// The colours of -c.
std::vector<float> draw_check_picture(const glare::Reading& reading, const glare::Measurement& measurement,
                                      const Settings& own);

}  // namespace evalglare
