// SPDX-License-Identifier: BSD-3-Clause
// Colours of given luminance, and the luminance they have after rounding to float (check_picture.h).
#include "glare/check_picture.h"

namespace glare {

Paint source_paint(uint32_t group) {
    constexpr Paint palette[] = {{0, 1, 0}, {0.15, 0.15, 0.7}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}};
    return palette[group % 5];
}

CheckPicture::CheckPicture(const Luminance& lum, bool to_be_seen) : grey_(lum.size()) {
    for (size_t i = 0; i < grey_.size(); ++i) {
        const double f = lum.grey[i];
        grey_[i] = (grey_red * f + grey_blue * f) + grey_green * f;
        if (to_be_seen) rgb_.insert(rgb_.end(), 3, lum.grey[i]);
    }
}

void CheckPicture::paint(size_t pixel, const Paint& paint) {
    const double grey = grey_[pixel];
    const float red = float(paint.red * (1 / grey_red) * grey), green = float(paint.green * (1 / grey_green) * grey),
                blue = float(paint.blue * (1 / grey_blue) * grey);
    grey_[pixel] = (grey_red * red + grey_blue * blue) + grey_green * green;
    if (rgb_.empty()) return;
    rgb_[3 * pixel] = red, rgb_[3 * pixel + 1] = green, rgb_[3 * pixel + 2] = blue;
}

}  // namespace glare
