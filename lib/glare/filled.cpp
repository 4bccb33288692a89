// SPDX-License-Identifier: BSD-3-Clause
// See filled.h.
#include "glare/filled.h"

#include "base/wide.h"

namespace glare {

constexpr float least_share = 1e-9f;  // least fraction: 1e-5 of the sun's fraction of a pixel of 3 degrees

Luminance FilledPixels::as(const Luminance& picture) {
    Luminance out = picture;
    out.grey = grey.data();
    out.share = share.data();
    return out;
}

namespace {
// A pixel without variance, or without light, is taken as one of luminance 1, whose fraction is 1.
WIDE_LOOP void fill(const float* moments, size_t n, float* grey, float* share) {
    for (size_t i = 0; i < n; ++i) {
        const float g = grey[i], v = moments[image::moment_numbers * i + image::moment_variance];
        const double light = g > 0 ? 1. : 0., varies = v > 0 ? light : 0., m1 = varies * double(g) + (1 - varies);
        const float rounded = float(m1 * m1 / (m1 * m1 + varies * double(v)));
        share[i] = rounded > least_share ? rounded : least_share;
        grey[i] = float(double(g) / double(share[i]));
    }
}
}  // namespace

FilledPixels filled_pixels(const Luminance& picture) {
    FilledPixels out;
    out.grey.assign(picture.grey, picture.grey + picture.size());
    out.share.resize(picture.size());
    fill(picture.moments->data(), picture.size(), out.grey.data(), out.share.data());
    return out;
}

}  // namespace glare
