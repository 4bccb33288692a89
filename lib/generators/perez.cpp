// SPDX-License-Identifier: BSD-3-Clause
// Tables and formulas of the Perez sky.  Bins of epsilon: 1 1.065 1.23 1.5 1.95 2.8 4.5 6.2 12.01.
#include "generators/perez.h"
#include <algorithm>
#include <cmath>
#include <iterator>
#include "base/angle.h"

namespace generators {

namespace {

constexpr double solar_constant = 1367;  // W/m2

int bin(double epsilon) {
    const double edges[7] = {1.065, 1.23, 1.5, 1.95, 2.8, 4.5, 6.2};
    return int(std::upper_bound(std::begin(edges), std::end(edges), epsilon) - std::begin(edges));
}

// clang-format off
const double diffuse_table[8][4] = {
    {97.24, -.46, 12, -8.91}, {107.22, 1.15, .59, -3.95}, {104.97, 2.96, -5.53, -8.77},
    {102.39, 5.59, -13.95, -13.90},
    {100.71, 5.94, -22.75, -23.74}, {106.42, 3.83, -36.15, -28.83},
    {141.88, 1.90, -53.24, -14.03}, {152.23, .35, -45.27, -7.98}};
const double direct_table[8][4] = {
    {57.20, -4.55, -2.98, 117.12}, {98.99, -3.46, -1.21, 12.38}, {109.83, -4.90, -1.71, -8.81},
    {110.34, -5.84, -1.99, -4.56},
    {106.36, -3.97, -1.75, -6.16}, {107.19, -1.25, -1.51, -26.73}, {105.75, .77, -1.26, -34.44},
    {101.18, 1.58, -1.10, -8.29}};

const double shape_table[8][5][4] = {
    {{1.3525, -.2576, -.2690, -1.4366}, {-.7670, .0007, 1.2734, -.1233}, {2.8000, .6004, 1.2375, 1.0000},
     {1.8734, .6297, .9738, .2809}, {.0356, -.1246, -.5718, .9938}},
    {{-1.2219, -.7730, 1.4148, 1.1016}, {-.2054, .0367, -3.9128, .9156}, {6.9750, .1774, 6.4477, -.1239},
     {-1.5798, -.5081, -1.7812, .1080}, {.2624, .0672, -.2190, -.4285}},
    {{-1.1000, -.2515, .8952, .0156}, {.2782, -.1812, -4.5000, 1.1766}, {24.7219, -13.0812, -37.7000, 34.8438},
     {-5.0000, 1.5218, 3.9229, -2.6204}, {-.0156, .1597, .4199, -.5562}},
    {{-.5484, -.6654, -.2672, .7117}, {.7234, -.6219, -5.6812, 2.6297}, {33.3389, -18.3000, -62.2500, 52.0781},
     {-3.5000, .0016, 1.1477, .1062}, {.4659, -.3296, -.0876, -.0329}},
    {{-.6000, -.3566, -2.5000, 2.3250}, {.2937, .0496, -5.6812, 1.8415}, {21.0000, -4.7656, -21.5906, 7.2492},
     {-3.5000, -.1554, 1.4062, .3988}, {.0032, .0766, -.0656, -.1294}},
    {{-1.0156, -.3670, 1.0078, 1.4051}, {.2875, -.5328, -3.8500, 3.3750}, {14.0000, -.9999, -7.1406, 7.5469},
     {-3.4000, -.1078, -1.0750, 1.5702}, {-.0672, .4016, .3017, -.4844}},
    {{-1.0000, .0211, .5025, -.5119}, {-.3000, .1922, .7023, -1.6317}, {19.0000, -5.0000, 1.2438, -1.9094},
     {-4.0000, .0250, .3844, .2656}, {1.0468, -.3788, -2.4517, 1.4656}},
    {{-1.0500, .0289, .4260, .3590}, {-.3250, .1156, .7781, .0025}, {31.0625, -14.5000, -46.1148, 55.3750},
     {-7.2312, .4050, 13.3500, .6234}, {1.5000, -.6426, 1.8564, .5636}}};
// clang-format on

}  // namespace

// Eccentricity of the earth's orbit: Spencer's series, as in the Perez papers.
PerezSky::PerezSky(int day_of_year, double zenith, double dew_point_c) : zenith_angle(zenith) {
    const double x = 2 * base::pi * (day_of_year - 1) / 365;
    extraterrestrial = solar_constant * (1.00011 + .034221 * std::cos(x) + .00128 * std::sin(x) +
                                         .000719 * std::cos(2 * x) + .000077 * std::sin(2 * x));
    water = std::exp(.07 * dew_point_c - .075);
}

double PerezSky::air_mass() const {
    const double z = std::min(zenith_angle, base::pi / 2);
    return 1 / (std::cos(z) + .15 * std::pow(93.885 - z * (180 / base::pi), -1.253));
}

Clearness PerezSky::clearness(double direct, double diffuse) const {
    const double k = 1.041 * std::pow(zenith_angle, 3);
    return {((diffuse + direct) / diffuse + k) / (1 + k), diffuse * air_mass() / extraterrestrial};
}

void PerezSky::irradiances(Clearness c, double& direct, double& diffuse) const {
    const double k = 1.041 * std::pow(zenith_angle, 3);
    diffuse = c.delta * extraterrestrial / air_mass();
    direct = diffuse * (c.epsilon - 1) * (1 + k);
}

double PerezSky::diffuse_efficacy(Clearness c) const {
    const double* t = diffuse_table[bin(c.epsilon)];
    return t[0] + t[1] * water + t[2] * std::cos(zenith_angle) + t[3] * std::log(c.delta);
}

double PerezSky::direct_efficacy(Clearness c) const {
    const double* t = direct_table[bin(c.epsilon)];
    return std::max(0., t[0] + t[1] * water + t[2] * std::exp(5.73 * zenith_angle - 5) + t[3] * c.delta);
}

Clearness clamp(Clearness c) { return {std::clamp(c.epsilon, 1., 12.009), std::clamp(c.delta, .01, .6)}; }

PerezShape::PerezShape(Clearness k, double z) {
    const auto& x = shape_table[bin(k.epsilon)];
    const double d = k.epsilon > 1.065 && k.epsilon < 2.8 ? std::max(k.delta, .2) : k.delta;
    for (int i = 0; i < 5; i++) c[i] = x[i][0] + x[i][1] * z + d * (x[i][2] + x[i][3] * z);
    if (bin(k.epsilon) == 0) {
        c[2] = std::exp(std::pow(d * (x[2][0] + x[2][1] * z), x[2][2])) - x[2][3];
        c[3] = -std::exp(d * (x[3][0] + x[3][1] * z)) + x[3][2] + d * x[3][3];
    }
}

double PerezShape::relative(double theta, double gamma) const {
    const double cg = std::cos(gamma);
    return (1 + c[0] * std::exp(c[1] / std::cos(theta))) * (1 + c[2] * std::exp(c[3] * gamma) + c[4] * cg * cg);
}

// Tregenza's 145 patches, counted as equal solid angles.
double PerezShape::horizontal(double z) const {
    const int count[] = {30, 30, 24, 24, 18, 12, 6, 1};
    double sum = 0;
    for (int ring = 0; ring < 8; ring++) {
        const double theta = (84 - 12 * ring) * base::degree;
        for (int k = 0; k < count[ring]; k++) {
            const double azimuth = 2 * base::pi * k / count[ring];
            const double cg = std::cos(theta) * std::cos(z) + std::sin(theta) * std::sin(z) * std::cos(azimuth);
            sum += relative(theta, std::acos(std::clamp(cg, -1., 1.))) * std::cos(theta);
        }
    }
    return sum * 2 * base::pi / 145;
}

}  // namespace generators
