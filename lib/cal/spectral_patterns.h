// SPDX-License-Identifier: BSD-3-Clause
// The spectral types of pattern.cpp: folded to R, G and B by the colour matching functions, as RADIANCE's RGB mode
// does, or to the bands of PatternSpec::bands.  A light's spectrum is summed in a band, that of a surface averaged.
#pragma once
#include <vector>
#include "cal/pattern_parts.h"

namespace cal {

void spectrum_pattern(Parts& p, std::vector<int>& out);
void specfile_pattern(Parts& p, std::vector<int>& out);
void specfunc_pattern(Parts& p, std::vector<int>& out);
void specdata_pattern(Parts& p, std::vector<int>& out);
void specpict_pattern(Parts& p, std::vector<int>& out);

// R, G and B of a surface, or of what colours a light, in the bands of the pattern; the same without bands.
std::vector<int> in_bands(Parts& p, const std::vector<int>& rgb);

// R, G, B of a picture (string `picture`) at u, v after the .cal file (string `cal`).
std::vector<int> picture_values(Parts& p, size_t picture, size_t cal);

}  // namespace cal
