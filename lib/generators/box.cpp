// SPDX-License-Identifier: BSD-3-Clause
// genbox material name sx sy sz [-i] [-b bevel | -r radius [-n segments] [-s]]: a box with a corner at the origin and
// normals outward.  A vertex code is its corner (bits x=1 y=2 z=4) plus the directions along which it is inset by the
// bevel or the radius (8, 16, 32).  Rounded edges and corners are cylinders and balls, or flat pieces with -n or -i:
// each edge a strip of so many quadrilaterals (the next power of 2), each corner's triangle halved along its sides as
// often. -s gives the pieces, as triangles, the normals of the round shape.
#include <algorithm>
#include <array>
#include <cmath>
#include "generators/generators.h"

namespace generators {

namespace {

// A triangle with a normal at each corner.  tmesh.cal's arguments: the axis along which the triangle is projected, then
// for each component of the normal the coefficients of u, v and 1, (u, v) the two coordinates after the axis.
void write_smooth_triangle(std::string& out, const std::string& material, const std::string& name,
                           const std::array<base::Vec3, 3>& v, const std::array<base::Vec3, 3>& normal) {
    const base::Vec3 e1 = v[1] - v[0], e2 = v[2] - v[0], n = cross(e1, e2);
    int axis = 0;
    for (int k = 1; k < 3; k++)
        if (std::fabs(n[k]) > std::fabs(n[axis])) axis = k;
    const bool flat = n[axis] == 0;  // no area, no texture
    if (!flat) {
        const int iu = (axis + 1) % 3, iv = (axis + 2) % 3;
        out += "\n" + quoted(material) + " texfunc Phong\n4 dx dy dz tmesh.cal\n0\n10\t" + std::to_string(axis) + "\n";
        for (int k = 0; k < 3; k++) {  // Cramer's rule; the determinant is the normal's component along the axis
            const double d1 = normal[1][k] - normal[0][k], d2 = normal[2][k] - normal[0][k];
            const double a = (d1 * e2[iv] - d2 * e1[iv]) / n[axis], b = (d2 * e1[iu] - d1 * e2[iu]) / n[axis];
            out +=
                "\t" + number(a) + "\t" + number(b) + "\t" + number(normal[0][k] - a * v[0][iu] - b * v[0][iv]) + "\n";
        }
    }
    write_polygon(out, flat ? material : "Phong", name, {v[0], v[1], v[2]});
}

const char* const plain_faces[] = {"1540", "4620", "2310", "3267", "5137", "6457"};

// clang-format off
const int faces[6][4] = {{051, 055, 054, 050}, {064, 066, 062, 060}, {032, 033, 031, 030},
                         {053, 052, 056, 057}, {065, 061, 063, 067}, {036, 034, 035, 037}};
const int edges[12][4] = {{031, 051, 050, 030}, {060, 062, 032, 030}, {050, 054, 064, 060}, {034, 036, 066, 064},
                          {037, 057, 056, 036}, {052, 062, 066, 056}, {052, 053, 033, 032}, {057, 067, 063, 053},
                          {061, 031, 033, 063}, {065, 067, 037, 035}, {055, 051, 061, 065}, {034, 054, 055, 035}};
const int corners[8][3] = {{030, 050, 060}, {051, 031, 061}, {032, 062, 052}, {064, 054, 034},
                           {036, 056, 066}, {065, 035, 055}, {053, 063, 033}, {037, 067, 057}};
const int round_edges[12][2] = {{070, 071}, {070, 074}, {070, 072}, {073, 071}, {073, 072}, {073, 077},
                                {075, 071}, {075, 074}, {075, 077}, {076, 072}, {076, 074}, {076, 077}};
// clang-format on

char code_letter(int code) { return "0123456789._ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"[code]; }

struct RoundedBox {
    std::string material, name;
    double size[3];
    double bevel = 0, radius = 0;
    bool inward = false;
    std::string* out;

    base::Vec3 vertex(int code) const {
        base::Vec3 v;
        for (int i = 0; i < 3; i++) {
            const bool far = (code >> i & 1) != inward;
            v[i] = far ? size[i] : 0;
            if (code >> i & 8) v[i] += (far ? -1 : 1) * (bevel + radius);
        }
        return v;
    }
    std::string letters(const int* code, int n) const {
        std::string s = name + ".";
        for (int i = 0; i < n; i++) s += code_letter(code[i]);
        return s;
    }
    void face(const int* code, int n) const {
        std::vector<base::Vec3> v;
        for (int i = 0; i < n; i++) v.push_back(vertex(code[i]));
        write_polygon(*out, material, letters(code, n), v);
    }
    void edge(const int* code) const {
        const base::Vec3 a = vertex(code[0]), b = vertex(code[1]);
        write_surface(*out, material, inward ? "tube" : "cylinder", letters(code, 2),
                      {a.x, a.y, a.z, b.x, b.y, b.z, radius});
    }
    void ball(int code) const {
        const base::Vec3 a = vertex(code);
        write_surface(*out, material, inward ? "bubble" : "sphere", letters(&code, 1), {a.x, a.y, a.z, radius});
    }
};

// The rounded box in flat pieces, in RADIANCE's order.  Directions on a corner's ball by the side they face: 030 z, 050
// y, 060 x.
class Pieces {
public:
    Pieces(const RoundedBox& box, int segments) : box_(box), segments_(segments) {}
    void write(bool smooth) {
        for (const auto& e : round_edges) edge(e[0] & 7, e[1] & 7);
        for (int k = 0; k < 8; k++) {
            const bool mirrored = (k ^ k >> 1 ^ k >> 2) & 1;
            const int first = mirrored ? 060 : 050, second = mirrored ? 050 : 060;
            corner(k, toward(k, first), toward(k, second), toward(k, 030), segments_);
        }
        std::reverse(edges_.begin(), edges_.end());
        if (!smooth) {
            std::reverse(corners_.begin(), corners_.end());
            std::swap(edges_, corners_);
        }
        for (const Piece& p : edges_) put(p, smooth);
        for (const Piece& p : corners_) put(p, smooth);
        for (size_t f = 6; f-- > 0;) {
            Piece p;
            for (int code : faces[f]) p.push_back({box_.vertex(code), {}});
            put(p, false);
        }
    }

private:
    struct Point {
        base::Vec3 p, normal;
    };
    using Piece = std::vector<Point>;

    // The normal is the one the box's sides have.
    Point on_ball(int corner, base::Vec3 direction) const {
        return {box_.vertex(corner | 070) + direction * box_.radius, direction * (box_.inward ? -1 : 1)};
    }
    base::Vec3 toward(int corner, int side) const {
        return unit(box_.vertex(corner | side) - box_.vertex(corner | 070));
    }
    // Between corners p and q, a strip around their common axis.
    void edge(int p, int q) {
        const int axis = p ^ q,
                  from = axis == 1   ? 030
                         : axis == 2 ? 060
                                     : 050,
                  to = axis == 1   ? 050
                       : axis == 2 ? 030
                                   : 060;
        std::vector<base::Vec3> arc{toward(p, from), toward(p, to)};
        for (int n = 1; n < segments_; n *= 2) {
            std::vector<base::Vec3> finer{arc[0]};
            for (size_t i = 1; i < arc.size(); i++) finer.insert(finer.end(), {unit(arc[i - 1] + arc[i]), arc[i]});
            arc = finer;
        }
        for (size_t i = 1; i < arc.size(); i++)
            edges_.push_back({on_ball(p, arc[i - 1]), on_ball(q, arc[i - 1]), on_ball(q, arc[i]), on_ball(p, arc[i])});
    }
    void corner(int at, base::Vec3 a, base::Vec3 b, base::Vec3 c, int segments) {
        if (segments == 1) return corners_.push_back({on_ball(at, a), on_ball(at, b), on_ball(at, c)});
        const base::Vec3 ab = unit(a + b), bc = unit(b + c), ca = unit(c + a);
        corner(at, a, ab, ca, segments / 2);
        corner(at, b, bc, ab, segments / 2);
        corner(at, c, ca, bc, segments / 2);
        corner(at, ab, bc, ca, segments / 2);
    }
    void put(const Piece& piece, bool smooth) {
        const auto name = [&] { return box_.name + "." + std::to_string(++written_); };
        if (!smooth) {
            std::vector<base::Vec3> v;
            for (const Point& q : piece) v.push_back(q.p);
            return write_polygon(*box_.out, box_.material, name(), v);
        }
        // A quadrilateral is cut from its second to its last corner.
        const size_t n = piece.size();
        for (size_t first : {n == 4 ? 1 : 0, 3}) {
            if (first >= n) break;
            const Point &a = piece[first], &b = piece[(first + 1) % n], &c = piece[(first + 2) % n];
            write_smooth_triangle(*box_.out, box_.material, name(), {a.p, b.p, c.p}, {a.normal, b.normal, c.normal});
        }
    }

    const RoundedBox& box_;
    const int segments_;
    std::vector<Piece> edges_, corners_;
    int written_ = 0;
};

}  // namespace

void genbox(const Call& call, std::string& out) {
    RoundedBox b;
    b.material = call.word(1, "the material");
    b.name = call.word(2, "the name");
    for (int i = 0; i < 3; i++) b.size[i] = call.real(3 + i, "the size");
    b.out = &out;
    int segments = 0;  // 2: round
    bool bevelled = false, round = false, smooth = false;
    for (size_t i = 6; call.has(i); i++) {
        const std::string& w = call.words[i];
        if (w == "-i") b.inward = true;
        else if (w == "-b") bevelled = true, b.bevel = call.real(++i, "-b");
        else if (w == "-r") round = true, b.radius = call.real(++i, "-r");
        else if (w == "-n") segments = int(call.integer(++i, "-n", 1, call.most));
        else if (w == "-s") smooth = true;
        else if (w == "-o") call.fail("-o writes a Wavefront file, which a scene cannot contain");
        else call.fail("unknown option " + w);
    }
    if ((bevelled && b.bevel <= 0) || (round && b.radius <= 0) || (bevelled && round))
        call.fail("bevel and radius must be positive, and only one of them given");
    for (double s : b.size)
        if (s <= 0) call.fail("the size must be positive");
    if (!bevelled && !round) {
        for (const char* digits : plain_faces) {
            std::vector<base::Vec3> v;
            for (int i = 0; i < 4; i++) v.push_back(b.vertex(digits[i] - '0'));
            write_polygon(out, b.material, b.name + "." + digits, v);
        }
        return;
    }
    if (round && (segments > 2 || (b.inward && segments != 2))) {
        int n = segments > 2 ? 4 : 32;
        while (n < segments) n *= 2;
        if (6 + 12. * n + 8. * n * n > double(call.most))
            call.fail("-n: more than " + std::to_string(call.most) + " polygons");
        return Pieces(b, n).write(smooth);
    }
    for (const auto& f : faces) b.face(f, 4);
    if (bevelled) {
        for (const auto& e : edges) b.face(e, 4);
        for (const auto& c : corners) b.face(c, 3);
    } else {
        for (const auto& e : round_edges) b.edge(e);
        for (int code = 070; code <= 077; code++) b.ball(code);
    }
}

}  // namespace generators
