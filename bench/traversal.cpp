// SPDX-License-Identifier: BSD-3-Clause
// Rays per second of processor time: the CPU's tree (this file's instruction set), the GPU's (scalar), and Embree's
// own traversal of the same triangles (rtcIntersect1/rtcOccluded1, default and ROBUST).  Scene and rays come from a
// seed: a room with a window and bumpy spheres; rays of cosine-distributed bounces and shadow rays to a ceiling lamp,
// in order. Usage: bench_traversal_<isa> [triangles in thousands, default 20] [rays in thousands, default 300]
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <string>
#include "unit/bvh_host.h"
#include "unit/embree_scene.h"

using bvh_scenes::Vec;

static double cpu_seconds() {  // of all threads
    timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
static double wall_seconds() {
    timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}
// "VmRSS" or "VmHWM" (the peak since the last reset) of this process, in bytes.
static double memory(const char* what) {
    std::ifstream in("/proc/self/status");
    for (std::string line; std::getline(in, line);)
        if (line.compare(0, std::strlen(what), what) == 0)
            return 1024 * std::atof(line.c_str() + std::strlen(what) + 1);
    return 0;
}
static void reset_peak() { std::ofstream("/proc/self/clear_refs") << 5; }

static bvh_scenes::Scene room(int thousands) {
    bvh_scenes::Scene s;
    s.box({-4, -3, 0}, {8, 6, 3});
    for (int i = 0; i < 40; i++) s.box({-3.9, -1.5 + 0.075 * i, 0.8}, {0.02, 0.05, 1.5});  // blinds
    const int balls = 30, n = std::max(2, int(std::sqrt(thousands * 1000.0 / balls / 4)));
    bvh_scenes::Random r(3);
    for (int i = 0; i < balls; i++)
        s = bvh_scenes::sphere_mesh(n, r.in(0.15, 0.5), {r.in(-3.3, 3.3), r.in(-2.4, 2.4), r.in(0.5, 2.4)}, 0.15, false,
                                    std::move(s));
    s.end_part();
    return s;
}

// Median time per call of five, in CPU seconds.
template <class F>
static double median(F f) {
    double t[5];
    for (double& x : t) {
        const double start = cpu_seconds();
        f();
        x = cpu_seconds() - start;
    }
    std::sort(t, t + 5);
    return t[2];
}

static std::vector<Vec> normals(const bvh_scenes::Scene& scene) {
    std::vector<Vec> normal(scene.next_prim);
    for (size_t i = 0; i < scene.tri_prim.size(); i++) {
        const auto at = [&](int k) {
            const float* v = &scene.vertices[3 * scene.triangles[3 * i + k]];
            return Vec{v[0], v[1], v[2]};
        };
        normal[scene.tri_prim[i]] = unit(cross(at(1) - at(0), at(2) - at(0)));
    }
    return normal;
}

struct Rays {
    std::vector<kernels::Ray> paths, shadows;
};

// Four hits of each path from the middle of the room; a shadow ray from each point.
static Rays bouncing_rays(const bvh_scenes::Scene& scene, const kernels::SceneTables& tables, size_t count) {
    const std::vector<Vec> normal = normals(scene);
    Rays rays;
    bvh_scenes::Random r(7);
    while (rays.paths.size() < count) {
        const Vec d = r.direction();
        kernels::Ray ray = {F3(0.1f, 0.2f, 1.3f), 0, F3(float(d.x), float(d.y), float(d.z)), 1e30f};
        for (int bounce = 0; bounce < 4; bounce++) {
            kernels::Hit hit;
            kernels::compact::trace_first(&tables, &ray, RAY_ALL, &hit);
            if (hit.prim == NO_HIT) break;
            const float3 p = kernels::madd3(ray.dir, hit.t, ray.org);
            Vec n = normal[hit.prim];
            if (dot(n, {ray.dir.x, ray.dir.y, ray.dir.z}) > 0) n = n * -1;
            const Vec out = unit(n + r.direction() * 0.999);
            const float3 o = kernels::offset_ray(p, F3(float(n.x), float(n.y), float(n.z)), hit.t);
            const Vec to = Vec{r.in(-1, 1), r.in(-1, 1), 2.99} - Vec{o.x, o.y, o.z};
            const double dist = std::sqrt(dot(to, to));
            rays.shadows.push_back({o, 0, F3(float(to.x / dist), float(to.y / dist), float(to.z / dist)),
                                    kernels::shadow_end(float(dist))});
            ray.org = o;
            ray.dir = F3(float(out.x), float(out.y), float(out.z));
            rays.paths.push_back(ray);
        }
    }
    return rays;
}

template <class Closest, class Any>
static void measure(const char* name, const Rays& rays, Closest closest, Any any) {
    double sum = 0;
    long blocked = 0;
    const auto paths = [&] {
        sum = 0;
        for (const auto& ray : rays.paths) {
            const float t = closest(ray);
            if (t < 1e30f) sum += t;
        }
    };
    const auto shadows = [&] {
        blocked = 0;
        for (const auto& ray : rays.shadows) blocked += any(ray);
    };
    paths();
    const double a = median(paths), b = median(shadows);
    std::printf("%-16s %6.2f closest  %6.2f any   Mrays per CPU second   (mean t %.6f, %ld blocked)\n", name,
                double(rays.paths.size()) / a / 1e6, double(rays.shadows.size()) / b / 1e6,
                sum / double(rays.paths.size()), blocked);
}

int main(int argc, char** argv) {
    const int thousands = argc > 1 ? std::atoi(argv[1]) : 20;
    const size_t count = size_t(argc > 2 ? std::atoi(argv[2]) : 300) * 1000;
    const auto scene = room(thousands);
    const auto in = scene.input();

    reset_peak();
    const double before = memory("VmRSS");
    double w = wall_seconds(), c = cpu_seconds();
    const auto b8 = bvh::build8(in[0]);
    w = wall_seconds() - w;
    c = cpu_seconds() - c;
    const double peak8 = memory("VmHWM") - before;
    const auto compact = bvh::build_compact(in[0]);
    const double tris = double(in[0].triangle_count);
    std::printf(
        "%.0f triangles; built in %.3f s (%.3f CPU s); bytes per triangle: BVH8 %.1f, compact %.1f; with BVH8's at "
        "most %.0f while building\n",
        tris, w, c, 4 * double(b8.nodes.size() + b8.leaves.size()) / tris,
        4 * double(compact.nodes.size() + compact.leaves.size()) / tris, peak8 / tris);

    const auto t8 = kernels::tables(scene, b8), compact_tables = kernels::tables(scene, compact);
    const Rays rays = bouncing_rays(scene, compact_tables, count);
    measure(
        "BVH8", rays,
        [&](const kernels::Ray& ray) {
            kernels::Hit h;
            kernels::wide::trace_first(&t8, &ray, RAY_ALL, &h);
            return h.t;
        },
        [&](const kernels::Ray& ray) { return kernels::wide::trace_any(&t8, &ray, RAY_ALL); });
    measure(
        "compact", rays,
        [&](const kernels::Ray& ray) {
            kernels::Hit h;
            kernels::compact::trace_first(&compact_tables, &ray, RAY_ALL, &h);
            return h.t;
        },
        [&](const kernels::Ray& ray) { return kernels::compact::trace_any(&compact_tables, &ray, RAY_ALL); });
    for (bool robust : {true, false}) {
        const bvh::EmbreeScene embree(in.data(), 1, robust, false);
        measure(
            robust ? "Embree1 ROBUST" : "Embree1", rays,
            [&](const kernels::Ray& ray) {
                return embree.closest(&ray.org.x, ray.tmin, &ray.dir.x, ray.tmax, RAY_ALL).t;
            },
            [&](const kernels::Ray& ray) { return embree.any(&ray.org.x, ray.tmin, &ray.dir.x, ray.tmax, RAY_ALL); });
    }
    return 0;
}
