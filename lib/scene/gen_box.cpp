// SPDX-License-Identifier: BSD-3-Clause
// genbox material name sx sy sz [-i] [-b bevel | -r radius]: a box with a corner at the origin and normals outward.
// A vertex code is its corner (bits x=1 y=2 z=4) plus the directions along which it is inset by the bevel (8, 16, 32).
#include "scene/generators.h"

namespace scene {

namespace {

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

struct Box {
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

}  // namespace

void genbox(const Call& call, std::string& out) {
    Box b;
    b.material = call.word(1, "the material");
    b.name = call.word(2, "the name");
    for (int i = 0; i < 3; i++) b.size[i] = call.real(3 + i, "the size");
    b.out = &out;
    for (size_t i = 6; call.has(i); i++) {
        const std::string& w = call.words[i];
        if (w == "-i") b.inward = true;
        else if (w == "-b") b.bevel = call.real(++i, "-b");
        else if (w == "-r") b.radius = call.real(++i, "-r");
        else call.fail("option " + w + " is not built in (run RADIANCE's genbox with -exec)");
    }
    if (b.bevel < 0 || b.radius < 0 || (b.bevel > 0 && b.radius > 0))
        call.fail("bevel and radius must be positive, and only one of them given");
    for (double s : b.size)
        if (s <= 0) call.fail("the size must be positive");
    if (b.bevel + b.radius == 0) {
        for (const char* digits : plain_faces) {
            std::vector<base::Vec3> v;
            for (int i = 0; i < 4; i++) v.push_back(b.vertex(digits[i] - '0'));
            write_polygon(out, b.material, b.name + "." + digits, v);
        }
        return;
    }
    for (const auto& f : faces) b.face(f, 4);
    if (b.bevel > 0) {
        for (const auto& e : edges) b.face(e, 4);
        for (const auto& c : corners) b.face(c, 3);
    } else {
        for (const auto& e : round_edges) b.edge(e);
        for (int code = 070; code <= 077; code++) b.ball(code);
    }
}

}  // namespace scene
