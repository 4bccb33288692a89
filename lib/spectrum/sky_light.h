// SPDX-License-Identifier: BSD-3-Clause
// Spectra of a sun and a sky that have none, from how bright they are.  The sky's is daylight of a temperature, by its
// mean luminance where it is clear (A. Diakite, TU Berlin: the sky colours of gendaylit -C) and of 6191 K where it is
// overcast.  The sun's is that of a black body of 6000 K behind the air that its height gives.
#pragma once
#include "spectrum/spectrum.h"

namespace spectrum {

struct SkyLight {
    double sun_sine = 0;            // of its height
    double sun_lx = 0, sky_lx = 0;  // on a plane that faces the sun; on a horizontal one, without the sun
};

// Clearness of Perez et al. 1990, from illuminances.
double clearness(const SkyLight& light);
double sky_kelvin(const SkyLight& light);

// Each has the value 1 by V.  The ground's is that of sun and sky together.
struct SkySpectra {
    Spectrum sun, sky, ground;
};
SkySpectra spectra_of(const SkyLight& light);

}  // namespace spectrum
