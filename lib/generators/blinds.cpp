// SPDX-License-Identifier: BSD-3-Clause
// genblinds material name depth width height nslats angle [-r|+r radius]: slats along y, stacked in z.
// A flat slat faces down for angle 0.  A curved one is an arc over the same two edges, -r sagging, +r bulging upward,
// in chords of at most 3 degrees.
#include <cmath>
#include "generators/generators.h"
#include "base/angle.h"

namespace generators {

void genblinds(const Call& call, std::string& out) {
    const std::string& material = call.word(1, "the material");
    const std::string& name = call.word(2, "the name");
    const double depth = call.real(3, "the depth"), width = call.real(4, "the width"),
                 height = call.real(5, "the height");
    const long long slats = call.integer(6, "the number of slats", 0, call.most);
    const double tilt = call.real(7, "the angle") * base::degree;
    double radius = 0;
    for (size_t i = 8; call.has(i); i++) {
        if (call.words[i] == "+r") radius = call.real(++i, "+r");
        else if (call.words[i] == "-r") radius = -call.real(++i, "-r");
        else call.fail("unknown option " + call.words[i]);
    }
    // Profile of a slat in its own plane: x along the depth, z up.
    std::vector<base::Vec3> profile{{0, 0, 0}, {depth, 0, 0}};
    if (radius != 0) {
        if (depth <= 0) call.fail("curved slats need a depth above 0");
        if (2 * std::fabs(radius) < depth) call.fail("the radius is smaller than half the depth");
        const double half = std::asin(depth / (2 * std::fabs(radius)));
        const int chords = int(2 * half / (3 * base::pi / 180) + .99999);
        profile.clear();
        for (int k = 0; k <= chords; k++) {
            const double a = half * (2. * k / chords - 1);
            profile.push_back(
                {depth / 2 + std::fabs(radius) * std::sin(a), 0, radius * (std::cos(a) - std::cos(half))});
        }
    }
    if (slats * static_cast<long long>(profile.size()) > call.most)
        call.fail("more than " + std::to_string(call.most) + " polygons");
    for (base::Vec3& p : profile)
        p = {p.x * std::cos(tilt) - p.z * std::sin(tilt), 0, p.x * std::sin(tilt) + p.z * std::cos(tilt)};
    for (long long n = 1; n <= slats; n++) {
        const base::Vec3 up{0, 0, height * (n - .5) / slats}, across{0, width, 0};
        for (size_t k = 0; k + 1 < profile.size(); k++) {
            const base::Vec3 a = profile[k] + up, b = profile[k + 1] + up;
            write_polygon(out, material, name + "." + std::to_string(n) + "." + std::to_string(k),
                          {a, a + across, b + across, b});
        }
    }
}

}  // namespace generators
