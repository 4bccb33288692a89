// SPDX-License-Identifier: BSD-3-Clause
// Action spectra, by which light is weighted in place of V, and their values for light in our scale.
//
// Light in a scene has no absolute spectrum: 179 times the mean of R, G and B is what it is in lux.  So a spectrum s
// has the value sum(s V) / sum(V) by V, which is 1 for s = 1 everywhere.  By an action a of the CIE S 026 it is
//     sum(s a) / sum(V) * sum(D65 V) / sum(D65 a),
// which times 179 is the equivalent daylight illuminance, and equal to V's value for D65.  By the weight of a file it
// is
//     sum(s a) / (683.002 sum(V)),
// which times 179 is what a weighs in W/m2 where the illuminance by V is the scene's.
#pragma once
#include <string>
#include "spectrum/spectrum.h"

namespace spectrum {

struct Action {
    std::string name;       // mel rh sc mc lc V, or the name part of a file
    std::string unit;       // lx or W/m2
    Spectrum value;         // of light: dot(value, s)
    double from_nm, to_nm;  // bands lie evenly between, the first and the last one open to 380 and 780 nm
    int default_bands = 9;
};

// word: a name, or a file (read_spectrum).  Throws Error: place -action.
Action action_of(const std::string& word, const base::Opener& by = {});
const Action& by_v();

// mEDI over Ev of a light, for mel; likewise of other actions.
double daylight_ratio(const Action& action, const Spectrum& light);

}  // namespace spectrum
