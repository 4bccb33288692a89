// SPDX-License-Identifier: BSD-3-Clause
// See primaries.h.
#include "image/primaries.h"

#include <cmath>

namespace image {
namespace {

Matrix3 inverse(const Matrix3& m) {
    const auto minor = [&](int a, int b, int c, int d) { return m[a] * m[d] - m[b] * m[c]; };
    const Matrix3 adjugate{minor(4, 5, 7, 8), minor(2, 1, 8, 7), minor(1, 2, 4, 5),
                           minor(5, 3, 8, 6), minor(0, 2, 6, 8), minor(2, 0, 5, 3),
                           minor(3, 4, 6, 7), minor(1, 0, 7, 6), minor(0, 1, 3, 4)};
    const double det = m[0] * adjugate[0] + m[1] * adjugate[3] + m[2] * adjugate[6];
    Matrix3 r;
    for (int i = 0; i < 9; ++i) r[i] = adjugate[i] / det;
    return r;
}

Matrix3 product(const Matrix3& a, const Matrix3& b) {
    Matrix3 r{};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            for (int k = 0; k < 3; ++k) r[3 * i + j] += a[3 * i + k] * b[3 * k + j];
    return r;
}

// Linear RGB -> XYZ: columns are the primaries, scaled so that R = G = B = 1 is the white point with Y = 1.
Matrix3 xyz_from_rgb(const Primaries& p) {
    Matrix3 chroma;
    for (int c = 0; c < 3; ++c) {
        chroma[c] = p[2 * c];
        chroma[3 + c] = p[2 * c + 1];
        chroma[6 + c] = 1 - p[2 * c] - p[2 * c + 1];
    }
    const Matrix3 inv = inverse(chroma);
    const double white[3] = {p[6] / p[7], 1, (1 - p[6] - p[7]) / p[7]};
    Matrix3 m;
    for (int c = 0; c < 3; ++c) {
        const double scale = inv[3 * c] * white[0] + inv[3 * c + 1] * white[1] + inv[3 * c + 2] * white[2];
        for (int r = 0; r < 3; ++r) m[3 * r + c] = chroma[3 * r + c] * scale;
    }
    return m;
}

}  // namespace

const Primaries radiance_primaries{.640, .330, .290, .600, .150, .060, .3333, .3333};

// The colours are the corners of a triangle; ACES' blue has y < 0.
bool are_primaries(const Primaries& p) {
    const double twice_area = (p[2] - p[0]) * (p[5] - p[1]) - (p[4] - p[0]) * (p[3] - p[1]);
    return std::isfinite(twice_area) && std::fabs(twice_area) > 1e-4 && std::isfinite(p[6]) && p[7] > 1e-4;
}

Matrix3 xyz_from_radiance_rgb() { return xyz_from_rgb(radiance_primaries); }
Matrix3 rgb_from_xyz() { return inverse(xyz_from_rgb(radiance_primaries)); }

std::optional<Matrix3> rgb_from_primaries(const Primaries& p) {
    for (size_t i = 0; i < p.size(); ++i)
        if (std::fabs(p[i] - radiance_primaries[i]) > .001) return product(rgb_from_xyz(), xyz_from_rgb(p));
    return std::nullopt;
}

void convert(std::vector<float>& rgb, const std::array<double, 3>& scale, const std::optional<Matrix3>& mix) {
    const bool scales = scale != std::array<double, 3>{1, 1, 1};
    for (size_t i = 0; i + 2 < rgb.size() && (mix || scales); i += 3) {
        const double in[3] = {rgb[i] * scale[0], rgb[i + 1] * scale[1], rgb[i + 2] * scale[2]};
        for (size_t c = 0; c < 3; ++c) {
            const double* row = mix ? &(*mix)[3 * c] : nullptr;
            rgb[i + c] = float(row ? row[0] * in[0] + row[1] * in[1] + row[2] * in[2] : in[c]);
        }
    }
}

}  // namespace image
