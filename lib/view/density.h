// SPDX-License-Identifier: BSD-3-Clause
// Solid angle per area of the picture: what a point of the picture stands for.
#pragma once
#include "view/view.h"

namespace view {

// At (X,Y), by central differences; 0 outside of the view.
double solid_angle_density(const Projector& p, double X, double Y);

}  // namespace view
