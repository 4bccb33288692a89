// SPDX-License-Identifier: BSD-3-Clause
// Spectra of light by the CIE's names: A, E, daylight of a colour temperature, fluorescent and LED lamps.
#pragma once
#include <string>
#include "spectrum/spectrum.h"

namespace spectrum {

// Daylight of 4000 to 25000 K (CIE 15, by its components S0, S1, S2).
Spectrum daylight(double kelvin);
// A, E, D50, D55, D65, D75, F2, F7, F11, F12, LED-B1 to B5, LED-BH1, LED-RGB1, LED-V1, LED-V2; 4000 to 25000: daylight
// of that temperature; else the name of a file (read_spectrum).  Throws Error (place).
Spectrum illuminant(const std::string& word, const std::string& place, const base::Opener& by = {});
const Spectrum& d65();

}  // namespace spectrum
