// SPDX-License-Identifier: BSD-3-Clause
// Time and memory that a scene of a million quadrilaterals takes to read: as text (.rad), as a frozen
// octree, and as a Wavefront mesh (two million triangles).  The files are made first, in the temporary folder; each is
// read by a process of its own, twice, and the second time (file in the page cache) is printed with the peak of its
// memory. Usage: bench_scene_load [thousands of quadrilaterals, default 1000]
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "portable_binary.h"
#include "scene/mesh.h"

namespace {

struct Quad {
    double x, y, z, side;
};
Quad quad(long i, long row) {
    const long col = i % row;
    return {.01 * double(col) + .001234, .01 * double(i / row), double(i * 7919 % 10007) / 10007, .01};
}

void write_rad(FILE* f, long n, long row) {
    std::fputs("void plastic m\n0\n0\n5 .5 .5 .5 0 0\n", f);
    for (long i = 0; i < n; i++) {
        const Quad q = quad(i, row);
        std::fprintf(f, "\nm polygon ground.%ld.%ld\n0\n0\n12\n", i / row, i % row);
        for (int k = 0; k < 4; k++)
            std::fprintf(f, "\t%18.12g\t%18.12g\t%18.12g\n", q.x + (k == 1 || k == 2 ? q.side : 0),
                         q.y + (k > 1 ? q.side : 0), q.z);
    }
}

// A frozen octree with an empty tree: readers that build their own hierarchy do not look at it.
void write_oct(FILE* f, long n, long row) {
    std::fputs("#?RADIANCE\nFORMAT=Radiance_octree\n\n", f);
    put(f, 283 + 4, 2);
    for (const char* s : {"0", "0", "0", "100", ""}) put_text(f, s);
    put(f, n + 1, 4);
    put(f, 0, 1);
    for (const char* s : {"plastic", "polygon", ""}) put_text(f, s);
    put(f, 0, 1), put(f, -1, 4), put_text(f, "m"), put(f, 0, 2), put(f, 5, 2);
    for (double v : {.5, .5, .5, 0., 0.}) put_real(f, v);
    for (long i = 0; i < n; i++) {
        const Quad q = quad(i, row);
        put(f, 1, 1), put(f, 0, 4);
        put_text(f, "ground." + std::to_string(i / row) + "." + std::to_string(i % row));
        put(f, 0, 2), put(f, 12, 2);
        for (int k = 0; k < 4; k++) {
            put_real(f, q.x + (k == 1 || k == 2 ? q.side : 0));
            put_real(f, q.y + (k > 1 ? q.side : 0));
            put_real(f, q.z);
        }
    }
    put(f, 255, 1);
}

void write_obj(FILE* f, long n, long row) {
    const long w = row + 1, rows = n / row;
    for (long i = 0; i < w * (rows + 1); i++)
        std::fprintf(f, "v %.6f %.6f %.6f\nvt %.6f %.6f\nvn 0.1 0.2 1\n", .01 * double(i % w), .01 * double(i / w),
                     double(i * 7919 % 1009) / 1e4, double(i % w) / double(row), double(i / w) / double(row));
    std::fputs("usemtl m\n", f);
    for (long i = 0; i < rows * row; i++) {
        const long a = i / row * w + i % row + 1, b = a + w;
        std::fprintf(f, "f %ld/%ld/%ld %ld/%ld/%ld %ld/%ld/%ld %ld/%ld/%ld\n", a, a, a, a + 1, a + 1, a + 1, b + 1,
                     b + 1, b + 1, b, b, b);
    }
}

double seconds() { return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count(); }
double kilobytes() {
    struct rusage u;
    getrusage(RUSAGE_SELF, &u);
    return double(u.ru_maxrss);
}

void read_once(const std::string& path, bool report) {
    const double before = kilobytes(), start = seconds();
    size_t pieces = 0;
    if (path.substr(path.size() - 4) == ".obj") pieces = scene::read_mesh(path).triangles.size();
    else pieces = scene::read_scene({path}, {}).objects.size();
    const double wall = seconds() - start;
    struct rusage u;
    getrusage(RUSAGE_SELF, &u);
    if (report)
        std::printf(
            "%-9s %8zu pieces %6.2f s (%.2f s of processor)  peak %4.0f bytes each\n",
            path.substr(path.rfind('/') + 1).c_str(), pieces, wall,
            double(u.ru_utime.tv_sec + u.ru_stime.tv_sec) + 1e-6 * double(u.ru_utime.tv_usec + u.ru_stime.tv_usec),
            (kilobytes() - before) * 1024 / double(pieces));
    std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
    const long n = 1000 * (argc > 1 ? std::atol(argv[1]) : 1000), row = std::lround(std::sqrt(double(n)));
    const std::string folder = std::filesystem::temp_directory_path() / ("scene_load." + std::to_string(getpid()));
    std::filesystem::create_directory(folder);
    struct Kind {
        const char* name;
        void (*write)(FILE*, long, long);
    };
    int failed = 0;
    for (const Kind k : {Kind{"text.rad", write_rad}, Kind{"tree.oct", write_oct}, Kind{"mesh.obj", write_obj}}) {
        const std::string path = folder + "/" + k.name;
        FILE* f = std::fopen(path.c_str(), "wb");
        if (!f) return 2;
        k.write(f, n, row);
        std::fclose(f);
        for (bool report : {false, true}) {
            const pid_t child = fork();
            if (child == 0) {
                try {
                    read_once(path, report);
                    _exit(0);
                } catch (const base::Error& e) {
                    std::fprintf(stderr, "%s\n", e.what());
                    _exit(1);
                }
            }
            int status = 0;
            waitpid(child, &status, 0);
            failed |= status;
        }
    }
    std::filesystem::remove_all(folder);
    return failed != 0;
}
