// SPDX-License-Identifier: BSD-3-Clause
// Linear RGB of other primaries, and XYZ, to RADIANCE's RGB.  Luminance is kept; the white point is not adapted.
#pragma once
#include <array>
#include <optional>
#include <vector>

namespace image {

using Primaries = std::array<double, 8>;  // chromaticities rx ry gx gy bx by wx wy
extern const Primaries radiance_primaries;
bool are_primaries(const Primaries& p);  // of three colours and a white that can be seen

// 3 x 3, row-major.  XYZ: Y = luminance / 179.
using Matrix3 = std::array<double, 9>;
Matrix3 rgb_from_xyz();
Matrix3 xyz_from_radiance_rgb();
// Nothing: they are RADIANCE's.
std::optional<Matrix3> rgb_from_primaries(const Primaries& p);

// Each colour times scale, channel by channel, then mixed by the matrix, if there is one.
void convert(std::vector<float>& rgb, const std::array<double, 3>& scale, const std::optional<Matrix3>& mix);

}  // namespace image
