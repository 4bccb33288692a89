// SPDX-License-Identifier: BSD-3-Clause
// X, Y, Z = integrals of f times the CIE 1931 2 degree colour matching functions (10 nm table of CIE 15, linear
// between), each divided by the integral of its own function so that equal energy is white; then XYZ -> RGB for the
// primaries
// (.640 .330) (.290 .600) (.150 .060), white (1/3 1/3).
#include "cal/spectrum.h"
#include <algorithm>
#include <cmath>

namespace cal {

namespace {

// x y z from 380 to 780 nm
const float matching[41][3] = {
    {.001368f, .000039f, .006450f},  {.004243f, .000120f, .020050f},  {.014310f, .000396f, .067850f},
    {.043510f, .001210f, .207400f},  {.134380f, .004000f, .645600f},  {.283900f, .011600f, 1.385600f},
    {.348280f, .023000f, 1.747060f}, {.336200f, .038000f, 1.772110f}, {.290800f, .060000f, 1.669200f},
    {.195360f, .090980f, 1.287640f}, {.095640f, .139020f, .812950f},  {.032010f, .208020f, .465180f},
    {.004900f, .323000f, .272000f},  {.009300f, .503000f, .158200f},  {.063270f, .710000f, .078250f},
    {.165500f, .862000f, .042160f},  {.290400f, .954000f, .020300f},  {.433450f, .994950f, .008750f},
    {.594500f, .995000f, .003900f},  {.762100f, .952000f, .002100f},  {.916300f, .870000f, .001650f},
    {1.026300f, .757000f, .001100f}, {1.062200f, .631000f, .000800f}, {1.002600f, .503000f, .000340f},
    {.854450f, .381000f, .000190f},  {.642400f, .265000f, .000050f},  {.447900f, .175000f, .000020f},
    {.283500f, .107000f, 0},         {.164900f, .061000f, 0},         {.087400f, .032000f, 0},
    {.046770f, .017000f, 0},         {.022700f, .008210f, 0},         {.011359f, .004102f, 0},
    {.005790f, .002091f, 0},         {.002899f, .001047f, 0},         {.001440f, .000520f, 0},
    {.000690f, .000249f, 0},         {.000332f, .000120f, 0},         {.000166f, .000060f, 0},
    {.000083f, .000030f, 0},         {.000042f, .000015f, 0},
};
const double xyz_to_rgb[3][3] = {{2.5653, -1.1668, -.3984}, {-1.0221, 1.9783, .0438}, {.0747, -.2519, 1.1772}};

double matched(double nm, int k) {
    if (nm < 380 || nm > 780) return 0;
    const double t = (nm - 380) / 10;
    const int i = std::min(int(t), 39);
    return matching[i][k] * (i + 1 - t) + matching[i + 1][k] * (t - i);
}

}  // namespace

std::array<double, 3> spectrum_weight(double nm, double step) {
    double xyz[3], total[3] = {0, 0, 0};
    for (double w = 380 + step / 2; w < 780; w += step)
        for (int k = 0; k < 3; k++) total[k] += matched(w, k);
    for (int k = 0; k < 3; k++) xyz[k] = matched(nm, k) / total[k];
    std::array<double, 3> rgb;
    for (size_t i = 0; i < 3; i++) {
        const double* m = xyz_to_rgb[i];
        rgb[i] = (m[0] * xyz[0] + m[1] * xyz[1] + m[2] * xyz[2]) / (m[0] + m[1] + m[2]);
    }
    return rgb;
}

std::array<double, 3> spectrum_rgb(const std::function<double(double)>& f, double step) {
    std::array<double, 3> sum{0, 0, 0};
    const int count = int(std::lround(400 / step));
    for (int i = 0; i < count; i++) {
        const double nm = 380 + (i + 0.5) * step, v = f(nm);
        if (v == 0) continue;
        const std::array<double, 3> w = spectrum_weight(nm, step);
        for (size_t k = 0; k < 3; k++) sum[k] += w[k] * v;
    }
    return sum;
}

std::array<double, 3> band_weight(double a, double b) {
    std::array<double, 3> sum{0, 0, 0};
    for (double nm = std::max(380., std::floor(std::min(a, b))); nm < std::min(780., std::max(a, b)); nm++) {
        const double inside = std::min(nm + 1, std::max(a, b)) - std::max(nm, std::min(a, b));
        const std::array<double, 3> w = spectrum_weight(nm + .5, 1);
        for (size_t k = 0; k < 3; k++) sum[k] += w[k] * inside;
    }
    return sum;
}

}  // namespace cal
