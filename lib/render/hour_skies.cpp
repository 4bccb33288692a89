// SPDX-License-Identifier: BSD-3-Clause
// See hour_skies.h.
#include "render/hour_skies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/angle.h"
#include "base/wide.h"
#include "flatten/pack.h"

namespace render {
namespace {

const double radius = sun_radius_deg * base::degree;
const double cap = 2 * std::pow(std::sin(radius / 2), 2);  // 1 - cos

// For loops that the compiler turns into vectors.  e^x to 6e-7, |x| < 10 (4e-6 below): 2^n times a series.
inline float exp_of(float x) {
    const float t = std::clamp(x, -87.f, 87.f) * 1.44269504f;
    const float n = float(int(t + (t < 0 ? -.5f : .5f))), f = (t - n) * .693147181f;
    const float p =
        1 + f * (1 + f * (.5f + f * (.166666667f + f * (.0416666418f + f * (.00833336078f + f * .00138935f)))));
    union {
        int32_t i;
        float f;
    } scale;
    scale.i = (int32_t(n) + 127) << 23;
    return p * scale.f;
}

// acos to 2e-8: Abramowitz and Stegun 4.4.46.
inline float acos_of(float x) {
    const float u = std::fabs(x);
    const float p = 1.5707963050f +
                    u * (-.2145988016f +
                         u * (.0889789874f +
                              u * (-.0501743046f +
                                   u * (.0308918810f + u * (-.0170881256f + u * (.0066700901f + u * -.0012624911f))))));
    const float r = std::sqrt(std::max(0.f, 1 - u)) * p;
    return x < 0 ? float(M_PI) - r : r;
}

}  // namespace

namespace {
// Neighbours in the sky have numbers near each other: bits of azimuth and height in turn (Morton 1966).
uint32_t place_in_sky(base::Vec3 d) {
    const double turn = std::atan2(d.y, d.x) / (2 * base::pi) + .5,
                 height = std::asin(std::clamp(d.z, -1., 1.)) / base::pi + .5;
    uint32_t code = 0;
    for (uint32_t bit = 0; bit < 8; bit++)
        code |= (uint32_t(turn * 255) >> bit & 1u) << 2 * bit | (uint32_t(height * 255) >> bit & 1u) << (2 * bit + 1);
    return code;
}
}  // namespace

std::vector<kernels::Source> suns_of(const std::vector<HourSky>& hours, std::vector<uint32_t>& of) {
    of.clear();
    for (uint32_t i = 0; i < hours.size(); i++)
        if (hours[i].sun_radiance > 0) of.push_back(i);
    std::vector<uint32_t> place;
    for (const HourSky& h : hours) place.push_back(place_in_sky(unit(h.sun)));
    std::stable_sort(of.begin(), of.end(), [&](uint32_t a, uint32_t b) { return place[a] < place[b]; });
    std::vector<kernels::Source> out;
    for (const uint32_t i : of) {
        const base::Vec3 d = unit(hours[i].sun),
                         u = unit(cross(d, std::fabs(d.x) < .5 ? base::Vec3{1, 0, 0} : base::Vec3{0, 1, 0}));
        kernels::Source q{};
        q.kind = SK_DISTANT;
        q.prim = NONE;
        q.mod = NONE;
        q.relay = NONE;
        q.light_type = kernels::M_LIGHT;
        q.spot_cos = NO_SPOT;
        q.centre = flatten::packed(d);
        q.u = flatten::packed(u * std::tan(radius));
        q.v = flatten::packed(cross(d, u) * std::tan(radius));
        q.cap = float(cap);
        q.area = float(2 * base::pi * cap);
        q.radius = float(std::sin(radius));
        q.hour = hours[i].number;
        out.push_back(q);
    }
    return out;
}

std::string hours_sky_text(double irradiance) {
    return fmt::format(
        "!gensky -ang 45 0 -u -B {:g}\nskyfunc glow sky_glow 0 0 4 1 1 1 0\nsky_glow source sky 0 0 4 0 0 1 180"
        "\nskyfunc glow ground_glow 0 0 4 1 1 1 0\nground_glow source ground 0 0 4 0 0 -1 180\n",
        irradiance);
}

SkyBlock::SkyBlock(const HourSky* hours, size_t count) : count_(count) {
    for (const HourSky* h = hours; h < hours + count; h++) {
        const base::Vec3 sun = unit(h->sun);
        level_.push_back(float(h->level));
        ground_.push_back(float(h->ground));
        horizon_.push_back(float(h->horizon));
        a_.push_back(float(h->shape[0]));
        b_.push_back(float(h->shape[1]));
        c_.push_back(float(h->shape[2]));
        d_.push_back(float(h->shape[3]));
        e_.push_back(float(h->shape[4]));
        x_.push_back(float(sun.x));
        y_.push_back(float(sun.y));
        z_.push_back(float(sun.z));
        sun_radiance_.push_back(float(h->sun_radiance));
        sun_irradiance_.push_back(float(h->sun_radiance * 2 * base::pi * cap));
    }
}

WIDEST_LOOP void SkyBlock::radiance(const float* dir, bool mirrored, float* out) const {
    const float dx = dir[0], dy = dir[1], dz = dir[2];
    const float weight = float(std::pow(double(dz) + 1.01, 20)), in = weight / (weight + 1), below = 1 / (weight + 1);
    const float slant = 1 / std::max(dz, .01f), disc = mirrored ? 1.f : 0.f;
    const float *level = level_.data(), *ground = (dz < 0 ? ground_ : horizon_).data(), *a = a_.data(), *b = b_.data(),
                *c = c_.data(), *d = d_.data(), *e = e_.data(), *x = x_.data(), *y = y_.data(), *z = z_.data(),
                *sun = sun_radiance_.data();
    const size_t n = count_;
    const float least_chord2 = 2 * float(cap);
    for (size_t h = 0; h < n; h++) {
        const float ex = dx - x[h], ey = dy - y[h], ez = dz - z[h], chord2 = ex * ex + ey * ey + ez * ez;
        const float cosine = std::clamp(1 - chord2 / 2, -1.f, 1.f), angle = acos_of(cosine);
        const float sky =
            level[h] * (1 + a[h] * exp_of(b[h] * slant)) * (1 + c[h] * exp_of(d[h] * angle) + e[h] * cosine * cosine);
        const float all = in * sky + below * ground[h];
        out[h] = chord2 <= least_chord2 && sun[h] > 0 ? disc * sun[h] : all;
    }
}

}  // namespace render
