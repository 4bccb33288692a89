// SPDX-License-Identifier: BSD-3-Clause
// Photographic tone curve: Reinhard, Stark, Shirley, Ferwerda 2002, "Photographic Tone Reproduction for Digital
// Images", Eqs. 1, 2 and 4; key value and white point chosen from the picture as in Reinhard 2002, "Parameter
// Estimation for Photographic Tone Reproduction" (Journal of Graphics Tools 7).
#include "image/tone.h"

#include <algorithm>
#include <cmath>

namespace image {
namespace {

// sRGB (IEC 61966-2-1) encoding of a display value 0..1.
uint8_t srgb(double v) {
    v = v > 0 ? std::min(v, 1.0) : 0;
    v = v <= 0.0031308 ? 12.92 * v : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
    return uint8_t(v * 255 + .5);
}

}  // namespace

Image8 photo(const Picture& p, const ToneOptions& options) {
    std::vector<double> lit;  // luminance of what is not black (a fisheye's corners are none of the picture)
    double log_sum = 0;
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double l = luminance(&p.rgb[i]);
        if (!(l > 1e-6) || std::isinf(l)) continue;
        lit.push_back(l);
        log_sum += std::log2(l);
    }
    double scale = 0, white2 = 1;
    if (!lit.empty()) {
        const auto percentile = [&](double share) {
            const auto at = lit.begin() + std::ptrdiff_t(share * double(lit.size() - 1));
            std::nth_element(lit.begin(), at, lit.end());
            return std::log2(*at);
        };
        const double mean = log_sum / double(lit.size()), low = percentile(.01), high = percentile(.99);
        const double spread = std::max(high - low, 1e-3);
        const double key = .18 * std::pow(4, std::clamp((2 * mean - low - high) / spread, -1.0, 1.0));
        scale = key * std::exp2(options.stops - mean);  // Eqs. 1, 2
        const double white = std::max(1.5 * std::exp2(spread - 5), 1.0);
        white2 = white * white;
    }
    Image8 out{p.width, p.height, std::vector<uint8_t>(p.rgb.size())};
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double world = luminance(&p.rgb[i]), l = scale * world;
        const double shown = l * (1 + l / white2) / (1 + l);  // Eq. 4
        const double factor = world > 0 && std::isfinite(shown) ? shown / world * lumens_per_watt : 0;
        for (size_t c = 0; c < 3; ++c) out.rgb[i + c] = srgb(p.rgb[i + c] * factor);
    }
    return out;
}

Image8 tone(const Picture& picture, const ToneOptions& options) {
    return options.kind == ToneOptions::Kind::photo ? photo(picture, options) : falsecolor(picture, options);
}

}  // namespace image
