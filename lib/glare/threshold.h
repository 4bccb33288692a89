// SPDX-License-Identifier: BSD-3-Clause
// Bright pixels: evalglare's threshold, task area, field-of-view cut and filling of -I.  Distances are evalglare's
// s(A,B) = 2 acos(dA . dB), compared with opening angles.
#pragma once
#include <vector>
#include "glare/connected_components.h"
#include "glare/geometry.h"
#include "glare/luminance.h"
#include "glare/settings.h"

namespace glare {

// cos(opening/2): a pixel is inside if its direction's dot product with the centre's is at least this.
double inside_cosine(double opening);

// Mean luminance of all pixels of a circle; those outside the field of view are black, or `as_they_are`.
double task_luminance(const Luminance& lum, const Geometry& geometry, const Circle& task, bool as_they_are = false);

// -b: factor (up to 100) of the reference luminance or cd/m2; default 2000, or 5 with a task.
float source_threshold(const Settings& settings, bool has_task, double reference);

// Search radius in pixels at the centre: opening / (s(C, C + (10,10)) / 10).
double radius_in_pixels(const Geometry& geometry, double opening);

std::vector<Run> bright_runs(const Luminance& lum, const Geometry& geometry, double above_cdm2);

// -G: pixels outside the field of vision are black (1 total field, 2 both eyes, 3 weighted by 1/P and both eyes).
std::vector<float> cut_field(const Luminance& lum, const Geometry& geometry, int type);

// -I: rows from y_min down to 1 repeat row y_min + 1, valid pixels from y_max up repeat the pixel below.
std::vector<float> fill_rows(const Luminance& lum, const Geometry& geometry, const Fill& fill);

// Type v only: percentage of pixels beyond the mean half side that are darker than 7 cd/m2 (a fisheye passed off as
// a perspective view has more than 70).
double black_corner_percent(const Luminance& lum);

}  // namespace glare
