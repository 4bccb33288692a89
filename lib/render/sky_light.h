// SPDX-License-Identifier: BSD-3-Clause
// How bright the sun and the sky of a scene are, and the spectra that they get by that (spectrum/sky_light.h).
#pragma once
#include "flatten/band_colours.h"
#include "flatten/flat_scene.h"
#include "render/hour_skies.h"
#include "scene/object.h"
#include "spectrum/sky_light.h"

namespace render {

// A sun is a distant surface of less than 4 degrees across; the sky is all others above the horizon.
spectrum::SkyLight sky_light(const flatten::FlatScene& tables);
spectrum::SkyLight sky_light(const HourSky& hour);

// With spectra of the suns, skies and grounds of a scene, by the names of their modifiers, where they have none.
flatten::LightSpectra with_sky_spectra(flatten::LightSpectra lights, const scene::Scene& scene,
                                       const flatten::FlatScene& tables);

}  // namespace render
