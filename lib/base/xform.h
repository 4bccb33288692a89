// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's transform options: -t x y z  -rx -ry -rz degrees  -s factor  -mx -my -mz  -i count.
// Row vectors, p' = p M; options act left to right; "-i n" repeats the options after it (up to the next -i) n times.
#pragma once
#include <string>
#include "base/span.h"
#include "base/vec.h"

namespace base {

// 4x3 affine; scale = signed scale factor (negative = mirrored).
struct Xform {
    double m[4][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}};
    double scale = 1;
};

Vec3 point(const Xform& x, Vec3 p);              // with the translation
Vec3 vector(const Xform& x, Vec3 v);             // without; lengths grow by |scale|
Xform multiply(const Xform& a, const Xform& b);  // a first, then b
Xform inverse(const Xform& x);

// Is this word the first of a transform (-t -rx -ry -rz -s -mx -my -mz -i)?
bool is_xform_option(const std::string& word);

// Parses words[at..] as transform options, x becomes their product; returns the number of words used (it stops at the
// first word that is not an option).  A missing or bad number throws Error(place).
int parse_xform(const Span<std::string>& words, size_t at, Xform& x, const std::string& place);

}  // namespace base
