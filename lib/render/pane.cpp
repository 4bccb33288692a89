// SPDX-License-Identifier: BSD-3-Clause
// See pane.h.
#include "render/pane.h"

#include <cmath>

namespace render {

using base::Vec3;

namespace {
// To decimal digits, since they become text.
double rounded(double v, double digits) { return std::round(v * digits) / digits + 0.; }
}  // namespace

std::vector<Vec3> rectangle_around(const flatten::FlatScene& tables, const flatten::HostTracer& tracer,
                                   const flatten::HostTracer::Found& found, double step) {
    constexpr int most_steps = 3000, halvings = 12;
    const Vec3 n = base::unit(found.normal), at = found.place;
    const bool level = std::fabs(n.z) > .999;
    const Vec3 along = level ? base::unit(base::cross({0, 1, 0}, n)) : base::unit(base::cross({0, 0, 1}, n));
    const Vec3 rising = base::cross(n, along);
    const uint32_t material = flatten::material_of(tables, found.prim, found.inst);
    const double above = step / 20;
    const auto goes_on = [&](const Vec3& p) {
        const auto met = tracer.closest(p + n * above, n * -1, 0, 2 * above, flatten::HostTracer::all);
        return met.t >= 0 && flatten::material_of(tables, met.prim, met.inst) == material;
    };
    const auto reach = [&](const Vec3& dir) {
        double in = 0, out = step;
        for (int k = 0; k < most_steps && goes_on(at + dir * out); k++) in = out, out += step;
        for (int k = 0; k < halvings; k++) (goes_on(at + dir * ((in + out) / 2)) ? in : out) = (in + out) / 2;
        return dir * ((in + out) / 2);
    };
    const Vec3 left = reach(along * -1), right = reach(along), low = reach(rising * -1), high = reach(rising);
    const double digits = std::pow(10, std::ceil(std::log10(50 / step)));
    std::vector<Vec3> corners{at + left + low, at + right + low, at + right + high, at + left + high};
    for (Vec3& c : corners) c = {rounded(c.x, digits), rounded(c.y, digits), rounded(c.z, digits)};
    return corners;
}

}  // namespace render
