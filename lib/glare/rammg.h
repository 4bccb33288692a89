// SPDX-License-Identifier: BSD-3-Clause
// RAMMG contrast (Rizzi et al. 2004; paper Eqs. 5 and 6): mean absolute difference to the eight neighbours, averaged
// over the levels of a 2 x 2-mean pyramid.
//   RAMMG = 1/m sum_levels 1/(8 n) sum_i sum_j a_j |L_i - L_j|,  a = 1/(4 + 2 sqrt 2) * (edge 1, corner sqrt(2)/2)
// Levels while both sides are above 2; an odd top row or right column is dropped; neighbours outside contribute 0.
#pragma once
#include "glare/geometry.h"
#include "glare/luminance.h"

namespace glare {

// interior: only pixels with 8 neighbours, n = all
enum class RammgArea { view, rectangle, interior, prototype_scale };

// view: only valid pixels (a parent is valid if its four children are); prototype_scale: interior without the 1/8.  nan
// if a side is 2 or less.  A Pyramid (pyramid.h) belongs to one view and area.
struct Pyramid;
double rammg(const Luminance& lum, const Pyramid& pyramid);

}  // namespace glare
