// SPDX-License-Identifier: BSD-3-Clause
// Tone curve: v = (L / white)^(1/2.2), white being the luminance that 98 % of the pixels stay below and four times the
// median at most, so that windows do not darken the room.  A region's tint mixes in by 45 % of its coverage; pixels on its
// border (coverage falls below one half next to them) get its colour itself.
#include "comfort/region_preview.h"
#include <algorithm>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <png.h>
#include "base/error.h"
#include "image/stream.h"

namespace region {
namespace {

// Hues by the golden angle: neighbours in the list differ well.
void colour(size_t k, double rgb[3]) {
    double hue = std::fmod(0.08 + double(k) * 0.61803398875, 1) * 6;
    for (int c = 0; c < 3; ++c) rgb[c] = std::clamp(std::fabs(std::fmod(hue + (c == 0 ? 3 : c == 1 ? 1 : 5), 6.0) - 3) - 1, 0.0, 1.0) * .85 + .15;
}

double white_of(const image::Picture& p) {
    std::vector<float> v(p.rgb.size() / 3);
    for (size_t i = 0; i < v.size(); ++i) v[i] = 0.265f * p.rgb[3 * i] + 0.670f * p.rgb[3 * i + 1] + 0.065f * p.rgb[3 * i + 2];
    v.erase(std::remove_if(v.begin(), v.end(), [](float x) { return !(x > 0 && std::isfinite(x)); }), v.end());
    if (v.empty()) return 1;
    auto quantile = [&](double q) {
        auto at = v.begin() + std::ptrdiff_t(q * double(v.size() - 1));
        std::nth_element(v.begin(), at, v.end());
        return double(*at);
    };
    return std::min(quantile(.98), 4 * quantile(.5));
}

}  // namespace

void write_preview(const std::string& path, const image::Picture& under, const image::MaskSet& set) {
    const int nx = under.width, ny = under.height;
    if (set.width != nx || set.height != ny)
        base::fail(path, fmt::format("the picture has {} x {} pixels, the regions {} x {}", nx, ny, set.width, set.height));
    const double white = white_of(under);
    std::vector<double> v(under.rgb.size());
    for (size_t i = 0; i < v.size(); ++i) v[i] = std::pow(std::clamp(double(under.rgb[i]) / white, 0.0, 1.0), 1 / 2.2);
    for (size_t m = 0; m < set.masks.size(); ++m) {
        const std::vector<float>& c = set.masks[m].coverage;
        double tint[3];
        colour(m, tint);
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                size_t i = size_t(y) * size_t(nx) + size_t(x);
                if (c[i] <= 0) continue;
                bool border = c[i] >= .5f && ((x > 0 && c[i - 1] < .5f) || (x + 1 < nx && c[i + 1] < .5f) ||
                                              (y > 0 && c[i - size_t(nx)] < .5f) || (y + 1 < ny && c[i + size_t(nx)] < .5f));
                double share = border ? 1 : .45 * double(c[i]);
                for (int k = 0; k < 3; ++k) v[3 * i + size_t(k)] += share * (tint[k] - v[3 * i + size_t(k)]);
            }
    }
    std::vector<png_byte> bytes(v.size());
    for (size_t i = 0; i < v.size(); ++i) bytes[i] = png_byte(v[i] * 255 + .5);
    png_image png;
    std::memset(&png, 0, sizeof png);
    png.version = PNG_IMAGE_VERSION;
    png.width = png_uint_32(nx);
    png.height = png_uint_32(ny);
    png.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string out(size, '\0');
    if (!png_image_write_to_memory(&png, &out[0], &size, 0, bytes.data(), 0, nullptr)) base::fail_system(path, png.message);
    out.resize(size);
    image::write_bytes(path, out);
}

}  // namespace region
