// SPDX-License-Identifier: BSD-3-Clause
// genprism material name {N x1 y1 .. | file | - < file} [-l lx ly lz] [-r radius] [-c] [-e]: a polygon of the x,y
// plane, extruded. With -r, edges and corners are rounded: the outline shrinks to the centres of balls that touch both
// adjacent sides,
//     c_i = v_i + r (a_i u_i + rot90 u_i),  u_i = unit(v_i-1 - v_i),  a_i = sqrt((1-c)/(1+c)),  c = u_i . u_i+1,
// a_i negative (no ball) where the outline turns the other way.
#include <cmath>
#include "base/find_file.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/text_reader.h"
#include "generators/generators.h"

namespace generators {

namespace {

using base::Vec3;

struct Prism {
    std::string material, name;
    std::vector<Vec3> v;  // z = 0
    Vec3 lift{0, 0, 1};
    double radius = 0;
    bool ends = true, closed = true;
};

void read_outline(const Call& call, const std::string& path, std::vector<Vec3>& v) {
    base::TextReader in = base::TextReader::from_file(base::beside(path, call.place), call.options.opener(call.place));
    std::string_view word;
    Vec3 p;
    for (int n = 0; in.word(word); n++) {
        if (!base::parse_real(word, p[n % 2]))
            call.fail(in.place() + ": \"" + base::excerpt(word) + "\" is not a number");
        if (n % 2) v.push_back(p);
        if (static_cast<long long>(v.size()) > call.most)
            call.fail("more than " + std::to_string(call.most) + " vertices");
    }
}

void plain(const Prism& p, std::string& out) {
    const size_t n = p.v.size();
    if (p.ends) {
        write_polygon(out, p.material, p.name + ".b", p.v);
        std::vector<Vec3> top;
        for (size_t i = n; i-- > 0;) top.push_back(p.v[i] + p.lift);
        write_polygon(out, p.material, p.name + ".t", top);
    }
    for (size_t k = 0; k + !p.closed < n; k++) {
        const Vec3 a = p.v[k], b = p.v[(k + 1) % n];
        write_polygon(out, p.material, p.name + "." + std::to_string(k + 1), {a, a + p.lift, b + p.lift, b});
    }
}

void rounded(const Prism& p, const Call& call, std::string& out) {
    const size_t n = p.v.size();
    const double side = p.lift.z < 0 ? -1 : 1, r = p.radius;
    std::vector<Vec3> centre(n), u(n);  // centres at z = 0
    std::vector<bool> convex(n);
    for (size_t i = 0; i < n; i++) u[i] = unit(p.v[(i + n - 1) % n] - p.v[i]);
    for (size_t i = 0; i < n; i++) {
        const Vec3 next = u[(i + 1) % n];
        const double c = dot(u[i], next);
        if (length(u[i]) == 0 || 1 + c < 1e-12) call.fail("-r: two vertices coincide or an edge turns back on itself");
        const double turn = u[i].x * next.y - u[i].y * next.x;
        const double a = (turn > 0 ? -1 : 1) * std::sqrt(std::fmax(0, (1 - c) / (1 + c)));
        convex[i] = a * side > 0;
        centre[i] = p.v[i] + Vec3{a * u[i].x - u[i].y, a * u[i].y + u[i].x, 0} * (r * side);
    }
    const Vec3 low{0, 0, r * side}, high{p.lift.x, p.lift.y, p.lift.z - r * side};
    auto ball = [&](const char* kind, size_t i, Vec3 at) {
        if (convex[i])
            write_surface(out, p.material, "sphere", p.name + kind + std::to_string(i + 1), {at.x, at.y, at.z, r});
    };
    auto rod = [&](const char* kind, size_t number, Vec3 a, Vec3 b) {
        write_surface(out, p.material, "cylinder", p.name + kind + std::to_string(number),
                      {a.x, a.y, a.z, b.x, b.y, b.z, r});
    };
    if (p.ends) {
        write_polygon(out, p.material, p.name + ".b", centre);
        std::vector<Vec3> top;
        for (size_t i = n; i-- > 0;) top.push_back(centre[i] + p.lift);
        write_polygon(out, p.material, p.name + ".t", top);
        for (int end = 0; end < 2; end++)
            for (size_t i = 0; i < n; i++) {
                const Vec3 shift = end ? high : low;
                ball(end ? ".tc" : ".bc", i, centre[i] + shift);
                rod(end ? ".te" : ".be", i + 1, centre[(i + n - 1) % n] + shift, centre[i] + shift);
            }
    }
    for (size_t k = 0; k + !p.closed < n; k++) {
        const size_t next = (k + 1) % n;
        const Vec3 out_by = unit(cross(p.lift, p.v[next] - p.v[k])) * r;
        const Vec3 a = centre[k] + out_by, b = centre[next] + out_by;
        write_polygon(out, p.material, p.name + "." + std::to_string(k + 1), {a + low, a + high, b + high, b + low});
        if (convex[next]) rod(".e", k + 1, centre[next] + low, centre[next] + high);
    }
}

}  // namespace

void genprism(const Call& call, std::string& out) {
    Prism p;
    p.material = call.word(1, "the material");
    p.name = call.word(2, "the name");
    const std::string& outline = call.word(3, "the outline");
    size_t i = 4;
    if (outline[0] >= '0' && outline[0] <= '9') {
        const long long n = call.integer(3, "the number of vertices", 3, call.most);
        for (long long k = 0; k < n; k++, i += 2) p.v.push_back({call.real(i, "x"), call.real(i + 1, "y"), 0});
    } else if (outline == "-" && call.input.empty()) {
        call.fail("\"-\" needs a file: genprism m p - < file");
    } else {
        read_outline(call, outline == "-" ? call.input : outline, p.v);
    }
    for (; call.has(i); i++) {
        const std::string& w = call.words[i];
        if (w == "-l")
            for (int j = 0; j < 3; j++) p.lift[j] = call.real(++i, "-l");
        else if (w == "-r") p.radius = call.real(++i, "-r");
        else if (w == "-c") p.closed = false;
        else if (w == "-e") p.ends = false;
        else call.fail("unknown option " + w);
    }
    if (p.v.size() < 3) call.fail("fewer than 3 vertices");
    if (p.lift.z == 0) call.fail("-l: the third number must not be 0");
    if (p.radius < 0 || 2 * p.radius > std::fabs(p.lift.z))
        call.fail("-r: the radius must be positive and at most half the height");
    if (p.radius > 0) rounded(p, call, out);
    else plain(p, out);
}

}  // namespace generators
