// SPDX-License-Identifier: BSD-3-Clause
// Colours of a rendering that are bands of wavelengths (spectrum/bands.h) in place of R, G and B.  A spectral pattern
// colours lights or surfaces.  A light without one has the spectrum of a lamp, by the name of its modifier, or of
// daylight; a surface without one that of its RGB.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>
#include "cal/pattern.h"
#include "scene/object.h"
#include "spectrum/bands.h"

namespace flatten {

struct LightSpectra {
    std::map<std::string, spectrum::Spectrum> lamps;  // by the name of a modifier
    spectrum::Spectrum daylight{};                    // of all other lights
    bool by_sky = false;                              // suns and skies have that of spectrum/sky_light.h
};

struct BandColours {
    spectrum::Bands bands;
    LightSpectra lights;
    std::string name;  // a hash of the rest
};

// Of each object: what a pattern colours, and whether a light has a spectrum by patterns.
struct SpectralUse {
    bool of_light = false, of_surface = false, has_spectrum = false;
};
using SpectralUses = std::vector<SpectralUse>;
SpectralUses spectral_uses(const scene::Scene& scene);

// Modifier i, a pattern or a material with functions, as written, with the bands.  colours: null, there are none.  o:
// the modifier, or what it is an alias of.  Throws Error where a spectrum colours both a light and a surface.
cal::PatternSpec pattern_spec(const BandColours* colours, const SpectralUses& uses, const scene::Scene& scene, size_t i,
                              const scene::Object& o);

// The real arguments of a material, that modifier i is, those that are colours in bands; as they are without colours.
std::vector<double> arguments_of(const BandColours* colours, const SpectralUses& uses, const scene::Scene& scene,
                                 size_t i, const scene::Object& material);

// Modifiers of the scene whose spectra are guessed: lights that are neither lamps nor have a spectrum, and coloured
// surfaces and patterns.  Each name once.
struct Guessed {
    std::vector<std::string> lights, surfaces;
    std::vector<std::string> lamps;  // that are no light of the scene, or have a spectrum
};
Guessed guessed_spectra(const scene::Scene& scene, const LightSpectra& lights);

}  // namespace flatten
