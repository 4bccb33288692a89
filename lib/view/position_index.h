// SPDX-License-Identifier: BSD-3-Clause
// Position index P of a direction (Guth), rounded to float as evalglare does.
//   sigma: angle from the line of sight; tau: angle of d/cos(sigma) - view direction from the up vector, 0 = straight
//   up.
// Above (and on) the line of sight (Guth 1963 as fitted in the IES handbook; Levin 1975), degrees:
//   P = exp((35.2 - 0.31889 tau - 1.22 e^(-2 tau/9)) 1e-3 sigma + (21 + 0.26667 tau - 0.002963 tau^2) 1e-5 sigma^2)
// Below (evalglare 3.02 and later): beta = atan(tan sigma sqrt(1 + 0.3225 cos^2 tau)),
//   P = exp(6.49e-3 beta + 21e-5 beta^2).   Both at most 16.
#pragma once
#include "view/view.h"

namespace view {

using base::Vec3;

// evalglare's rad-to-degree literal (3.1415927): used wherever its printed degrees are ours.
constexpr double evalglare_pi = 3.1415927;
constexpr double evalglare_deg = 180 / evalglare_pi;

enum class PositionModel {
    guth,       // above
    kim,        // Kim et al. 2009, everywhere, no cap (evalglare -P 1)
    accelerad,  // Guth above with the picture's up axis, the older Iwata form below (evalglare before 2.13)
};

struct EyeAngles {
    double sigma_deg, tau_deg, elevation_deg;
    bool behind = false;  // the eye, where the index goes on to rise; false: it is that of the direction opposite
};

// tau is measured from the view's up vector as given (not made perpendicular), or from the picture's up axis.
EyeAngles eye_angles(const Projector& p, Vec3 d, bool picture_up = false);
double position_index(const Projector& p, Vec3 d, PositionModel model = PositionModel::guth);
// The same from angles that are known.
double position_index(const EyeAngles& angles, const Projector& p, Vec3 d, PositionModel model);
// ln P by Guth, not rounded, for unit d ahead of the eye: takes a third of the time, for borders that are evaluated
// millions of times.
double log_position_index(const Projector& p, Vec3 d);

}  // namespace view
