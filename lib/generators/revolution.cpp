// SPDX-License-Identifier: BSD-3-Clause
// genrev material name z(t) r(t) nseg [-s]: a surface of revolution about z, a cone, cylinder, tube, cup or ring for
// each step of t = 0..1.  -s smooths: to each piece's normal the neighbour's is added, all of it at their common edge.
// genworm material name x(t) y(t) z(t) r(t) nseg: balls of radius r along a curve, joined by cones tangent to both.
#include <cmath>
#include "base/error.h"
#include "base/hypot.h"
#include "generators/functions.h"

namespace generators {

namespace {

// Normal of a piece of the profile: x radial, y axial.
struct Normal2 {
    double radial, axial;
};
Normal2 piece_normal(double z0, double r0, double z1, double r1) {
    const double dz = z1 - z0, dr = r1 - r0, l = base::hypot(dz, dr);
    return l > 0 ? Normal2{dz / l, -dr / l} : Normal2{0, 0};
}

// Slope and offset of the line through (x0, y0), (x1, y1); the constant `flat` where it is upright.
void line(double x0, double y0, double x1, double y1, double flat, std::string& out) {
    const double slope = x1 == x0 ? 0 : (y1 - y0) / (x1 - x0);
    out += "\t" + number(slope) + "\t" + number(x1 == x0 ? flat : y0 - slope * x0) + "\n";
}

}  // namespace

void genrev(const Call& call, std::string& out) {
    const std::string& material = call.word(1, "the material");
    const std::string& name = call.word(2, "the name");
    Functions f(call);
    f.define("rev_z", "t", call.word(3, "z(t)"));
    f.define("rev_r", "t", call.word(4, "r(t)"));
    const long long n = call.integer(5, "the number of segments", 1, call.most);
    bool smooth = false;
    for (size_t i = 6; call.has(i); i++) {
        if (call.words[i] == "-s") smooth = true;
        else if (!f.option(i)) call.fail("unknown option " + call.words[i]);
    }
    std::vector<double> z, r;
    for (long long i = 0; i <= n; i++) {
        z.push_back(f("rev_z", {double(i) / double(n)}));
        r.push_back(f("rev_r", {double(i) / double(n)}));
    }
    // Values that differ by rounding alone are equal, so that a flat or upright piece is known as such.
    double largest = 0;
    for (size_t i = 0; i < z.size(); i++) largest = std::fmax(largest, std::fmax(std::fabs(z[i]), std::fabs(r[i])));
    for (size_t i = 1; i < z.size(); i++) {
        if (std::fabs(z[i] - z[i - 1]) <= 1e-9 * largest) z[i] = z[i - 1];
        if (std::fabs(r[i] - r[i - 1]) <= 1e-9 * largest) r[i] = r[i - 1];
    }
    auto normal = [&](long long i) {  // of piece i = 1..n; nothing beyond the ends
        return i < 1 || i > n ? Normal2{0, 0} : piece_normal(z[i - 1], r[i - 1], z[i], r[i]);
    };
    for (long long i = 1; i <= n; i++) {
        const double z0 = z[i - 1], r0 = r[i - 1], z1 = z[i], r1 = r[i];
        if (z0 == z1 && r0 == r1) continue;
        std::string modifier = material;
        if (smooth) {
            const Normal2 before = normal(i - 1), here = normal(i), after = normal(i + 1);
            out += "\n" + quoted(material) + " texfunc Phong\n4 rev_dx rev_dy rev_dz rev.cal\n0\n4\n";
            line(z0, before.axial, z1, after.axial, here.axial, out);
            line(r0, before.radial, r1, after.radial, here.radial, out);
            modifier = "Phong";
        }
        const std::string piece = name + "." + std::to_string(i);
        if (z0 == z1) write_surface(out, modifier, "ring", piece, {0, 0, z0, 0, 0, r0 > r1 ? 1. : -1., r0, r1});
        else if (r0 == r1) write_surface(out, modifier, z0 < z1 ? "cylinder" : "tube", piece, {0, 0, z0, 0, 0, z1, r0});
        else write_surface(out, modifier, z0 < z1 ? "cone" : "cup", piece, {0, 0, z0, 0, 0, z1, r0, r1});
    }
}

void genworm(const Call& call, std::string& out) {
    const std::string& material = call.word(1, "the material");
    const std::string& name = call.word(2, "the name");
    Functions f(call);
    const char* const names[] = {"worm_x", "worm_y", "worm_z", "worm_r"};
    for (size_t k = 0; k < 4; k++) f.define(names[k], "t", call.word(3 + k, "x(t) y(t) z(t) r(t)"));
    const long long n = call.integer(7, "the number of segments", 1, call.most);
    for (size_t i = 8; call.has(i); i++)
        if (!f.option(i)) call.fail("unknown option " + call.words[i]);
    base::Vec3 last;
    double last_r = 0;
    for (long long i = 0; i <= n; i++) {
        const std::vector<double> t{double(i) / double(n)};
        const base::Vec3 p{f(names[0], t), f(names[1], t), f(names[2], t)};
        const double r = f(names[3], t);
        const base::Vec3 d = p - last;
        if (i > 0 && r == last_r) {
            write_surface(out, material, "cylinder", name + ".c" + std::to_string(i),
                          {last.x, last.y, last.z, p.x, p.y, p.z, r});
        } else if (i > 0 && dot(d, d) > 0) {
            // The cone touches both balls where the plane of contact cuts the axis.
            const double slope = (last_r - r) / dot(d, d), shrink = std::sqrt(std::fmax(0, 1 - (last_r - r) * slope));
            const base::Vec3 a = last + d * (slope * last_r), b = p + d * (slope * r);
            write_surface(out, material, "cone", name + ".c" + std::to_string(i),
                          {a.x, a.y, a.z, b.x, b.y, b.z, last_r * shrink, r * shrink});
        }
        write_surface(out, material, "sphere", name + ".s" + std::to_string(i), {p.x, p.y, p.z, r});
        last = p;
        last_r = r;
    }
}

}  // namespace generators
