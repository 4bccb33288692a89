// SPDX-License-Identifier: BSD-3-Clause
// The light of many hours: suns as records of the kernels, and the radiance of all their skies in one direction.
#pragma once
#include <array>
#include <string>
#include <vector>
#include "base/vec.h"
#include "kernels/dialect/host.h"

namespace render {

// An hour's sky as `perezlum` gives it (lib/cal), grey, W/(sr m2).
struct HourSky {
    uint32_t number = 0;           // of the hour: decides random numbers
    base::Vec3 sun;                // unit
    double sun_radiance = 0;       // 0: it does not shine
    double level = 0, ground = 0;  // A1, A2 below the horizon
    double horizon = 0;            // A2 above it: another one where the sky has little light (weather/light.h)
    double shape[5] = {};          // A3 .. A7: Perez' a b c d e
    double sky_irradiance = 0;     // horizontal, without the sun

    // Light of a colour: factors of the three channels, all 1 where it is grey.
    struct Tint {
        std::array<float, 3> sun{1, 1, 1}, sky{1, 1, 1}, ground{1, 1, 1};
    };
    Tint tint;
    bool tinted = false;
};
constexpr double sun_radius_deg = .2665;

// Those that shine, neighbours in the sky next to each other; of[i]: the hour of sun i.
std::vector<kernels::Source> suns_of(const std::vector<HourSky>& hours, std::vector<uint32_t>& of);

// Scene text of a uniform sky of this horizontal irradiance, with which paths are aimed.
std::string hours_sky_text(double irradiance);

constexpr size_t most_hours_together = 64;

// A block of at most so many hours, side by side.
class SkyBlock {
public:
    SkyBlock(const HourSky* hours, size_t count);
    size_t size() const { return count_; }
    // Radiance of each in this direction.  mirrored: the disc of the sun shines there, else it is black.
    void radiance(const float* dir, bool mirrored, float* out) const;
    float sun_irradiance(size_t hour) const { return sun_irradiance_[hour]; }

private:
    size_t count_;
    std::vector<float> level_, ground_, horizon_, a_, b_, c_, d_, e_, x_, y_, z_, sun_radiance_, sun_irradiance_;
};

}  // namespace render
