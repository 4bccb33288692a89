// SPDX-License-Identifier: BSD-3-Clause
// A heap of triangles on the floor of the office of `examples`, 3 x 5 m and some centimetres high: as a compiled mesh
// and the frozen octree that places it, or each triangle a polygon of its own, as a frozen octree or as text.  obj2mesh
// does not end for ten million, and oconv takes minutes.  The trees are left empty, which readers that build a
// hierarchy of their own do not look at. Usage: large_mesh TRIANGLES (heap.rtm heap.oct | heap.oct | heap.rad)
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

// As RADIANCE's binary files hold them.
void put(FILE* f, long long v, int bytes) {
    while (bytes-- > 0) std::putc(int(v >> (8 * bytes) & 255), f);
}
void put_real(FILE* f, double v) {
    int e = 0;
    const double m = std::frexp(v, &e);
    put(f, v == 0 ? 0 : (long long)(m * 0x7fffffff), 4);
    put(f, v == 0 ? 0 : e, 1);
}
void put_text(FILE* f, const std::string& s) { std::fwrite(s.c_str(), 1, s.size() + 1, f); }

constexpr int PATCH = 15;                 // quadrilaterals along each side of a patch: 256 vertices, 450 triangles
constexpr double X = 0, Y = 0, SIZE = 6;  // of the cube whose 32-bit fractions the coordinates are

FILE* open(const char* path) {
    FILE* f = std::fopen(path, "wb");
    if (!f) std::perror(path), std::exit(2);
    return f;
}

struct Point {
    double x, y, z;
};
// Corner (i, j) of the grid of side x side quadrilaterals
Point corner(long i, long j, long side) {
    const double x = double(i) / double(side), y = double(j) / double(side);
    return {.5 + 3 * x, .2 + 5 * y, .02 + .02 * std::sin(37 * x) * std::cos(41 * y)};
}

void put_fraction(FILE* f, double v) { put(f, (long long)(v / SIZE * 4294967296.), 4); }

void begin(FILE* f, const char* format, int magic) {
    std::fprintf(f, "#?RADIANCE\nFORMAT=%s\n\n", format);
    put(f, magic + 4, 2);  // object numbers take four bytes
}

// The table of types and the first object
void put_material(FILE* f, const char* surface) {
    for (const char* type : {"plastic", surface, ""}) put_text(f, type);
    put(f, 0, 1), put(f, -1, 4), put_text(f, "heap_carpet"), put(f, 0, 2), put(f, 5, 2);
    for (double v : {.2, .2, .25, 0., 0.}) put_real(f, v);
}

void write_mesh(const char* path, long side) {
    FILE* f = open(path);
    begin(f, "Radiance_tmesh", 319);
    for (double v : {X, Y, 0., SIZE}) put_text(f, std::to_string(v));
    for (int k = 0; k < 4; k++) put_real(f, 0);
    put(f, 0, 1);
    put_material(f, "mesh"), put(f, 255, 1);
    const long patches = (side + PATCH - 1) / PATCH;
    side = patches * PATCH;
    put(f, patches * patches, 4);
    for (long a = 0; a < patches; a++)
        for (long b = 0; b < patches; b++) {
            put(f, 1, 1), put(f, (PATCH + 1) * (PATCH + 1), 2);
            for (int i = 0; i <= PATCH; i++)
                for (int j = 0; j <= PATCH; j++) {
                    const Point p = corner(a * PATCH + i, b * PATCH + j, side);
                    put_fraction(f, p.x - X), put_fraction(f, p.y - Y), put_fraction(f, p.z);
                }
            put(f, 2 * PATCH * PATCH, 2);
            for (int i = 0; i < PATCH; i++)
                for (int j = 0; j < PATCH; j++) {
                    const int v = i * (PATCH + 1) + j, w = v + PATCH + 1;
                    for (int corner : {v, w, w + 1, v, w + 1, v + 1}) put(f, corner, 1);
                }
            put(f, 1, 2), put(f, 0, 2), put(f, 0, 2), put(f, 0, 2);  // one material, no triangles between patches
        }
    std::fclose(f);
}

// An octree up to its first object; the tree is empty.
FILE* open_octree(const char* path, long objects, const char* surface) {
    FILE* f = open(path);
    begin(f, "Radiance_octree", 283);
    for (const char* s : {"0", "0", "0", "10", ""}) put_text(f, s);
    put(f, objects, 4), put(f, 0, 1);
    put_material(f, surface);
    return f;
}

void write_octree(const char* path, const char* mesh) {
    FILE* f = open_octree(path, 2, "mesh");
    put(f, 1, 1), put(f, -1, 4), put_text(f, "heap"), put(f, 1, 2), put_text(f, mesh), put(f, 0, 2);
    put(f, 255, 1);
    std::fclose(f);
}

// Calls put(name, its three corners) for each triangle.
template <class Put>
void each_triangle(long side, const Put& put) {
    for (long i = 0; i < side; i++)
        for (long j = 0; j < side; j++) {
            const Point p[4] = {corner(i, j, side), corner(i + 1, j, side), corner(i + 1, j + 1, side),
                                corner(i, j + 1, side)};
            for (int k : {1, 2}) put("heap." + std::to_string(2 * (i * side + j) + k), {p[0], p[k], p[k + 1]});
        }
}
using Corners = std::initializer_list<Point>;

void write_polygons(const char* path, long side) {
    FILE* f = open_octree(path, 1 + 2 * side * side, "polygon");
    each_triangle(side, [&](const std::string& name, Corners corners) {
        put(f, 1, 1), put(f, 0, 4), put_text(f, name), put(f, 0, 2), put(f, 9, 2);
        for (const Point& p : corners) put_real(f, p.x), put_real(f, p.y), put_real(f, p.z);
    });
    put(f, 255, 1);
    std::fclose(f);
}

void write_text(const char* path, long side) {
    FILE* f = open(path);
    std::fputs("void plastic heap_carpet 0 0 5 .2 .2 .25 0 0\n", f);
    each_triangle(side, [&](const std::string& name, Corners corners) {
        std::fprintf(f, "heap_carpet polygon %s 0 0 9", name.c_str());
        for (const Point& p : corners) std::fprintf(f, " %.9g %.9g %.9g", p.x, p.y, p.z);
        std::putc('\n', f);
    });
    std::fclose(f);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 3 && argc != 4)
        return std::fputs("usage: large_mesh TRIANGLES (heap.rtm heap.oct | heap.oct | heap.rad)\n", stderr), 1;
    const long side = std::lround(std::sqrt(std::atof(argv[1]) / 2));
    const std::string path = argv[2];
    if (argc == 4) write_mesh(argv[2], side), write_octree(argv[3], argv[2]);
    else if (path.substr(path.rfind('.') + 1) == "rad") write_text(argv[2], side);
    else write_polygons(argv[2], side);
    return 0;
}
