// SPDX-License-Identifier: BSD-3-Clause
// See sky_light.h.
#include "render/sky_light.h"

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "flatten/evaluate.h"
#include "flatten/pack.h"
#include "image/picture.h"

namespace render {
namespace {

using kernels::Distant;

bool is_sun(const Distant& d) { return d.cap < 1 - std::cos(2 * base::degree); }

double lux_of(double watts) { return image::lumens_per_watt * watts; }

}  // namespace

spectrum::SkyLight sky_light(const flatten::FlatScene& tables) {
    constexpr int rings = 40, sectors = 80;  // each with the same share of the horizontal illuminance
    spectrum::SkyLight light;
    for (const Distant& d : tables.distant) {
        const base::Vec3 to = flatten::vec_of(d.dir);
        if (is_sun(d)) {
            const double lx = lux_of(flatten::distant_luminance(tables, d, to) * 2 * base::pi * d.cap);
            if (lx > light.sun_lx) light.sun_lx = lx, light.sun_sine = to.z;
            continue;
        }
        double sum = 0;
        for (int i = 0; i < rings * sectors; i++) {
            const double z = std::sqrt((i / sectors + .5) / rings), flat = std::sqrt(1 - z * z);
            const double turn = 2 * base::pi * (i % sectors + .5) / sectors;
            const base::Vec3 dir{flat * std::cos(turn), flat * std::sin(turn), z};
            if (1 - dot(dir, to) <= d.cap) sum += flatten::distant_luminance(tables, d, dir);
        }
        light.sky_lx += lux_of(sum * base::pi / (rings * sectors));
    }
    return light;
}

spectrum::SkyLight sky_light(const HourSky& hour) {
    const double cap = 1 - std::cos(sun_radius_deg * base::degree);
    return {unit(hour.sun).z, lux_of(hour.sun_radiance * 2 * base::pi * cap), lux_of(hour.sky_irradiance)};
}

flatten::LightSpectra with_sky_spectra(flatten::LightSpectra lights, const scene::Scene& scene,
                                       const flatten::FlatScene& tables) {
    const spectrum::SkySpectra spectra = spectrum::spectra_of(sky_light(tables));
    for (size_t i = 0; i < tables.distant.size(); i++) {
        const Distant& d = tables.distant[i];
        const int32_t modifier = scene.objects[tables.distant_object[i]].modifier;
        const bool is_ground = d.dir.z < 0 && d.cap < 1.5f;
        if (modifier < 0) continue;
        lights.lamps.emplace(scene.name(scene.objects[size_t(modifier)]), is_sun(d)   ? spectra.sun
                                                                          : is_ground ? spectra.ground
                                                                                      : spectra.sky);
    }
    return lights;
}

}  // namespace render
