// SPDX-License-Identifier: BSD-3-Clause
// A heap of triangles on the floor of the office of `examples`, 3 x 5 m and some centimetres high, as a compiled mesh
// and the frozen octree that places it: obj2mesh and oconv do not end for ten million.  Their own trees are left empty,
// which readers that build a hierarchy of their own do not look at. Usage: large_mesh TRIANGLES heap.rtm heap.oct
#include <cstdlib>
#include <vector>

#include "portable_binary.h"

namespace {

constexpr int PATCH = 15;                 // quadrilaterals along each side of a patch: 256 vertices, 450 triangles
constexpr double X = 0, Y = 0, SIZE = 6;  // of the cube whose 32-bit fractions the coordinates are

FILE* open(const char* path) {
    FILE* f = std::fopen(path, "wb");
    if (!f) std::perror(path), std::exit(2);
    return f;
}

void put_fraction(FILE* f, double v) { put(f, (long long)(v / SIZE * 4294967296.), 4); }

void begin(FILE* f, const char* format, int magic) {
    std::fprintf(f, "#?RADIANCE\nFORMAT=%s\n\n", format);
    put(f, magic + 4, 2);  // object numbers take four bytes
}

void put_material(FILE* f) {
    for (const char* type : {"plastic", "mesh", ""}) put_text(f, type);
    put(f, 0, 1), put(f, -1, 4), put_text(f, "heap_carpet"), put(f, 0, 2), put(f, 5, 2);
    for (double v : {.2, .2, .25, 0., 0.}) put_real(f, v);
}

void write_mesh(const char* path, long side) {
    FILE* f = open(path);
    begin(f, "Radiance_tmesh", 319);
    for (double v : {X, Y, 0., SIZE}) put_text(f, std::to_string(v));
    for (int k = 0; k < 4; k++) put_real(f, 0);
    put(f, 0, 1);
    put_material(f), put(f, 255, 1);
    const long patches = (side + PATCH - 1) / PATCH;
    side = patches * PATCH;
    put(f, patches * patches, 4);
    for (long a = 0; a < patches; a++)
        for (long b = 0; b < patches; b++) {
            put(f, 1, 1), put(f, (PATCH + 1) * (PATCH + 1), 2);
            for (int i = 0; i <= PATCH; i++)
                for (int j = 0; j <= PATCH; j++) {
                    const double x = double(a * PATCH + i) / double(side), y = double(b * PATCH + j) / double(side);
                    put_fraction(f, .5 + 3 * x - X), put_fraction(f, .2 + 5 * y - Y);
                    put_fraction(f, .02 + .02 * std::sin(37 * x) * std::cos(41 * y));
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

void write_octree(const char* path, const char* mesh) {
    FILE* f = open(path);
    begin(f, "Radiance_octree", 283);
    for (const char* s : {"0", "0", "0", "10", ""}) put_text(f, s);
    put(f, 2, 4), put(f, 0, 1);
    put_material(f);
    put(f, 1, 1), put(f, -1, 4), put_text(f, "heap"), put(f, 1, 2), put_text(f, mesh), put(f, 0, 2);
    put(f, 255, 1);
    std::fclose(f);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 4) return std::fputs("usage: large_mesh TRIANGLES heap.rtm heap.oct\n", stderr), 1;
    write_mesh(argv[2], std::lround(std::sqrt(std::atof(argv[1]) / 2)));
    write_octree(argv[3], argv[2]);
    return 0;
}
