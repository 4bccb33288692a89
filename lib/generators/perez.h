// SPDX-License-Identifier: BSD-3-Clause
// The Perez all-weather sky as gendaylit uses it: R. Perez, R. Seals, J. Michalsky, "All-weather model for sky
// luminance distribution", Solar Energy 50 (1993), and Perez et al., "Modeling daylight availability and irradiance
// components from direct and global irradiance", Solar Energy 44 (1990) for the luminous efficacies. Irradiances in
// W/m2, illuminances in lx, angles in radians.
#pragma once

namespace generators {

// Sky clearness epsilon and brightness delta of a direct-normal and a diffuse-horizontal irradiance.
struct Clearness {
    double epsilon, delta;
};

struct PerezSky {
    double zenith_angle;      // of the sun
    double extraterrestrial;  // normal irradiance of this day
    double water;             // precipitable water, cm

    PerezSky(int day_of_year, double zenith_angle, double dew_point_c);
    double air_mass() const;
    Clearness clearness(double direct_normal, double diffuse) const;              // not clamped
    void irradiances(Clearness c, double& direct_normal, double& diffuse) const;  // the inverse
    double diffuse_efficacy(Clearness c) const;
    double direct_efficacy(Clearness c) const;
};
Clearness clamp(Clearness c);

// The five coefficients of the relative luminance, f(theta, g) = (1 + a e^(b/cos theta)) (1 + c e^(d g) + e cos^2 g).
struct PerezShape {
    double c[5];
    PerezShape(Clearness clearness, double zenith_angle);
    double relative(double theta, double gamma) const;
    double horizontal(double zenith_angle) const;  // integral of f cos(theta) over the sky's 145 patches
};

}  // namespace generators
