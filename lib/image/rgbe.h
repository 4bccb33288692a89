// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's 4-byte pixels: common exponent (Ward 1991, "Real Pixels", Graphics Gems II) and their scanlines,
// flat, old run-length and new run-length.  value = (byte + 0.5) * 2^(E - 136), 0 if E = 0: the half makes the
// mean of what was rounded down right.
#pragma once
#include <cstdint>
#include <string>
#include "image/input.h"

namespace image {

// One scanline, 4 * width bytes; throws Error (place) if it is cut or malformed.
void read_rgbe_row(Input& in, int width, uint8_t* row, const std::string& place);
// Appends one scanline of 4 * width bytes, new run-length for widths 17..32767, else flat.
void append_rgbe_row(std::string& out, const uint8_t* row, int width);

void rgbe_to_float(const uint8_t* row, int width, float* rgb);
void float_to_rgbe(const float* rgb, int width, uint8_t* row);  // negative and NaN channels become 0

}  // namespace image
