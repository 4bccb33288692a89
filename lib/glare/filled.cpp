// SPDX-License-Identifier: BSD-3-Clause
// See filled.h.
#include "glare/filled.h"

#include <algorithm>

namespace glare {

constexpr double least_share = 1e-9;  // least fraction: 1e-5 of the sun's fraction of a pixel of 3 degrees

Luminance FilledPixels::as(const Luminance& picture) {
    Luminance out = picture;
    out.grey = grey.data();
    out.share = share.data();
    return out;
}

FilledPixels filled_pixels(const Luminance& picture) {
    FilledPixels out;
    out.grey.assign(picture.grey, picture.grey + picture.size());
    out.share.assign(picture.size(), 1.0f);
    for (size_t i = 0; i < out.grey.size(); ++i) {
        const double m1 = out.grey[i], v = (*picture.moments)[image::moment_numbers * i + image::moment_variance];
        if (!(v > 0) || !(m1 > 0)) continue;
        out.share[i] = float(std::max(least_share, m1 * m1 / (m1 * m1 + v)));
        out.grey[i] = float(m1 / out.share[i]);
    }
    return out;
}

}  // namespace glare
