// SPDX-License-Identifier: BSD-3-Clause
// Tone curves; see tone.h for their sources.
#include "display/tone.h"

#include <algorithm>
#include <cmath>

namespace display {
namespace {

// The picture with each pixel multiplied by factor(its luminance, cd/m2), sRGB encoded.
template <class FACTOR>
Image8 encoded(const image::Picture& p, bool in_grey, FACTOR&& factor) {
    const ColourTable& srgb = srgb_codes();
    Image8 out{p.width, p.height, std::vector<uint8_t>(p.rgb.size())};
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double world = image::luminance(&p.rgb[i]), by = factor(world);
        for (size_t c = 0; c < 3; ++c)
            out.rgb[i + c] = srgb.at(in_grey ? world * by : p.rgb[i + c] * by * image::lumens_per_watt)[0];
    }
    return out;
}

double photographic(double world, const Exposure& e) {
    const double l = e.scale * world;
    const double shown = l * (1 + l / e.white2) / (1 + l);
    return world > 0 && std::isfinite(shown) ? shown / world : 0;
}

}  // namespace

Exposure automatic_exposure(const image::Picture& p) {
    std::vector<double> lit;  // luminance of what is not black (a fisheye's corners are none of the picture)
    double log_sum = 0;
    for (size_t i = 0; i + 2 < p.rgb.size(); i += 3) {
        const double l = image::luminance(&p.rgb[i]);
        if (!(l > 1e-6) || std::isinf(l)) continue;
        lit.push_back(l);
        log_sum += std::log2(l);
    }
    if (lit.empty()) return {};

    const auto percentile = [&](double share) {
        const auto at = lit.begin() + std::ptrdiff_t(share * double(lit.size() - 1));
        std::nth_element(lit.begin(), at, lit.end());
        return std::log2(*at);
    };
    const double mean = log_sum / double(lit.size()), low = percentile(.01), high = percentile(.99);
    const double spread = std::max(high - low, 1e-3);
    const double key = .18 * std::pow(4, std::clamp((2 * mean - low - high) / spread, -1.0, 1.0));
    const double white = std::max(1.5 * std::exp2(spread - 5), 1.0);
    return {key * std::exp2(-mean), white * white};
}

Image8 photo(const image::Picture& p, const Exposure& e) {
    return encoded(p, false, [&](double world) { return photographic(world, e); });
}

Image8 grey(const image::Picture& p, const Exposure& e) {
    return encoded(p, true, [&](double world) { return photographic(world, e); });
}

Image8 linear(const image::Picture& p, const Exposure& e) {
    const double by = e.scale / std::sqrt(e.white2);
    return encoded(p, false, [&](double) { return by; });
}

Image8 tone(const image::Picture& p, const ToneOptions& o) {
    using Kind = ToneOptions::Kind;
    if (o.kind == Kind::falsecolor) return falsecolor(p, o);
    Exposure e = automatic_exposure(p);
    e.scale *= std::exp2(o.stops);
    return o.kind == Kind::photo ? photo(p, e) : o.kind == Kind::grey ? grey(p, e) : linear(p, e);
}

}  // namespace display
