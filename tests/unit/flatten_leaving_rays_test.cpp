// SPDX-License-Identifier: BSD-3-Clause
// Where rays start (kernels/bvh/offset_ray.h): no ray meets the surface that it just left, none escapes from a closed
// room, and starts lie within the stated bound of the surface, on their side, for triangles, slivers, shapes and
// instances of all sizes, near the origin of the tables and far from it.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>
#include <fmt/core.h>

#include <random>

#include "flatten/flatten.h"
#include "unit/scene_text.h"
#include "unit/bvh_scenes.h"

namespace kernels {
#include "kernels/all.h"
}  // namespace kernels

namespace {
using base::Vec3;
using bvh_scenes::Random;
using namespace kernels;

#define POINT_AT_BVH(type, name) tables.name = tree->name.data();
#define POINT_AT_SCENE(type, name) tables.name = flat.name.data();
class Traced {
public:
    // Most of its surfaces lie about the origin, so that the origin of the tables is there.
    explicit Traced(const std::string& text, const std::string& extra = "") {
        std::string all = "void plastic m 0 0 5 .5 .5 .5 0 0\n";
        if (extra.empty())
            for (int i = 0; i < 9; i++) all += fmt::format("m sphere s{} 0 0 4 {} 0 0 .01\n", i, i - 4);
        const Folder folder;
        if (!extra.empty()) Folder::write("in.obj", extra);
        Folder::write("t.rad", all + text);
        const scene::ReadOptions how;
        flat = flatten::flatten(scene::read_scene({"t.rad"}, how), {}, how);
        tree = flat.built.wide;
        BVH_TABLES(POINT_AT_BVH)
        FLAT_TABLES(POINT_AT_SCENE)
    }
    bool meet(const Ray& ray, Hit& hit, Surface& g) const {
        trace_closest(&tables, &ray, RAY_ALL, &hit);
        if (hit.prim == NO_HIT) return false;
        surface_at(&tables, &ray, &hit, &g);
        return true;
    }
    flatten::FlatScene flat;

private:
    std::shared_ptr<const bvh::Tree> tree;
    SceneTables tables{};
};

float3 to_float(Vec3 v) { return F3(float(v.x), float(v.y), float(v.z)); }
Vec3 to_double(float3 v) { return {v.x, v.y, v.z}; }
Vec3 direction(Random& r) {
    const bvh_scenes::Vec d = r.direction();
    return {d.x, d.y, d.z};
}
std::string text(Vec3 v) { return fmt::format(" {:.17g} {:.17g} {:.17g}", v.x, v.y, v.z); }

// A thing at a place: its text, its surface as numbers.
struct Thing {
    std::string kind;
    double size;
    Vec3 at, axis, across, other;  // unit, perpendicular
    double radius = 0, length = 0;

    Thing(const std::string& kind, double size, Vec3 at, Random& r) : kind(kind), size(size), at(at) {
        axis = direction(r);
        across = unit(cross(axis, direction(r)));
        other = cross(axis, across);
        if (r.engine() % 3 == 0) axis = {0, 0, 1}, across = {1, 0, 0}, other = {0, 1, 0};
        radius = kind == "sphere" ? size / 2 : size * std::pow(10, r.in(-3, -.3));
        length = size;
    }
    std::string corners(double w) const {
        const Vec3 u = across * (size / 2), v = other * (w / 2);
        return text(at - u - v) + text(at + u - v) + text(at + u + v) + text(at - u + v);
    }
    std::string scene(double thin) const {
        if (kind == "quad") return "m polygon p 0 0 12" + corners(size * thin) + "\n";
        if (kind == "outline") return "m polygon p 0 0 15" + corners(size * thin) + text(at - across * size) + "\n";
        if (kind == "ring") return "m ring p 0 0 8" + text(at) + text(axis) + fmt::format(" 0 {:.17g}\n", size / 2);
        if (kind == "sphere") return "m sphere p 0 0 4" + text(at) + fmt::format(" {:.17g}\n", radius);
        const Vec3 half = axis * (length / 2);
        return fmt::format("m {} p 0 0 {}", kind, kind == "cone" ? 8 : 7) + text(at - half) + text(at + half) +
               fmt::format(" {:.17g}", radius) + (kind == "cone" ? fmt::format(" {:.17g}", radius / 3) : "") + "\n";
    }
    Vec3 goal(double thin, Random& r) const {
        const double u = r.in(-.45, .45) * size, v = r.in(-.45, .45) * size * thin;
        if (kind == "quad" || kind == "outline") return at + across * u + other * v;
        if (kind == "ring") return at + across * (.7 * u) + other * (r.in(-.3, .3) * size);
        if (kind == "sphere") return at + direction(r) * (.8 * radius);
        return at + axis * u + direction(r) * (.2 * radius);
    }
    bool curved() const { return kind == "sphere" || kind == "cone" || kind == "cylinder"; }
    // Signed distance from its surface, outside (or on axis's side) positive.
    double distance(Vec3 p) const {
        const Vec3 q = p - at;
        if (kind == "sphere") return base::length(q) - radius;
        const double along = dot(q, axis);
        if (!curved()) return along;
        const double at_end = kind == "cone" ? radius / 3 : radius, slope = (radius - at_end) / length;
        const double here = radius - slope * (along + length / 2);
        return (base::length(q - axis * along) - here) / std::sqrt(1 + slope * slope);
    }
};

// Rays that leave to both sides of what they met: starts beyond the bound, and rays that meet it again.
struct Count {
    int met = 0, beyond = 0, again = 0;
};
void leave(const Thing& thing, double thin, Random& r, int rays, Count& count) {
    const Traced scene(thing.scene(thin));
    const uint32_t own = uint32_t(scene.flat.prims.size() - 1);
    for (int i = 0; i < rays; i++) {
        const Vec3 goal = thing.goal(thin, r);
        const Vec3 from = goal + direction(r) * (thing.size * std::pow(10, r.in(-1, 3)));
        const Vec3 d = base::unit(goal - from);
        const Ray ray = {to_float(from), 0, to_float(d), FAR_AWAY};
        Hit hit;
        Surface g;
        if (!scene.meet(ray, hit, g) || hit.prim != own) continue;
        count.met++;
        for (const double side : {1., -1.}) {
            const float3 n = side > 0 ? g.nface : neg3(g.nface);
            const float3 start = offset_ray(g.p, n, g.rounding);
            const double away = thing.distance(to_double(start)) * side;
            count.beyond += !(away > 0 && away < 2.01 * g.rounding);
            const double cosine = std::pow(10, r.in(-4, 0));
            const Vec3 normal = to_double(n), tangent = base::unit(cross(normal, direction(r)));
            const Vec3 out = base::unit(normal * cosine + tangent * std::sqrt(1 - cosine * cosine));
            const Ray next = {start, 0, to_float(out), FAR_AWAY};
            Hit later;
            Surface there;
            if (!scene.meet(next, later, there) || later.prim != own) continue;
            // from within a curved thing the chord is at least the sphere's of the largest curvature
            const double chord = thing.curved() && side < 0 ? 2 * thing.radius * cosine : 1e30;
            if (thing.kind == "cone" && side < 0 && later.t > .1 * chord) continue;
            count.again += later.t < .5 * chord;
        }
    }
}

}  // namespace

TEST_CASE("starts lie within their bound, and no ray meets what it left") {
    Random r(7);
    for (const char* kind : {"quad", "outline", "ring", "sphere", "cylinder", "cone"})
        for (const double place : {0., 1., 30., 1000., 20000.})
            for (const double thin : {1., .01, .0003}) {
                const bool flat = std::string(kind) == "quad" || std::string(kind) == "outline";
                if (!flat && thin < 1) continue;
                Count count;
                for (int k = 0; k < 24; k++) {
                    const double size = std::pow(10, r.in(-3, 3.3));
                    const Thing thing(kind, size, direction(r) * place, r);
                    // coordinates say little of a ball smaller than their last places
                    if (thing.curved() && thing.radius < 2e-5 * place) continue;
                    leave(thing, thin, r, 400, count);
                }
                const std::string name = kind;
                CAPTURE(name);
                CAPTURE(place);
                CAPTURE(thin);
                CHECK(count.met > 1500);
                CHECK(count.beyond == 0);
                CHECK(count.again == 0);
            }
}

// A closed ball of triangles about its own origin, as text of an .obj file.
static std::string ball(double radius) {
    std::string out = "usemtl m\n";
    const int n = 40;
    for (int i = 0; i <= n; i++)
        for (int j = 0; j < 2 * n; j++) {
            const double a = M_PI * i / n, b = M_PI * j / n;
            out += fmt::format("v {:.17g} {:.17g} {:.17g}\n", radius * std::sin(a) * std::cos(b),
                               radius * std::sin(a) * std::sin(b), radius * std::cos(a));
        }
    const auto corner = [&](int i, int j) { return 2 * n * i + j % (2 * n) + 1; };
    for (int i = 0; i < n; i++)
        for (int j = 0; j < 2 * n; j++) {
            if (i + 1 < n) out += fmt::format("f {} {} {}\n", corner(i, j), corner(i + 1, j), corner(i + 1, j + 1));
            if (i > 0) out += fmt::format("f {} {} {}\n", corner(i, j), corner(i + 1, j + 1), corner(i, j + 1));
        }
    return out;
}

TEST_CASE("no ray escapes from a closed ball of triangles in an instance, turned, scaled and far away") {
    struct Place {
        double scale, move;
    };
    for (const Place& place : {Place{1, 0}, Place{1, 100}, Place{1, 1000}, Place{.01, 20}, Place{100, 5000}}) {
        // a mesh at a distance, and enough about the origin to keep the tables' origin there
        std::string things;
        for (int i = 0; i < 3; i++) things += fmt::format("m sphere s{} 0 0 4 {} 0 0 .01\n", i, 1e-3 * i);
        const Vec3 at = Vec3{1, -.3, .1} * place.move;
        const Traced scene(
            things +
                fmt::format("void mesh b 11 in.obj -s {} -rx 33 -rz 21 -t {} {} {}", place.scale, at.x, at.y, at.z) +
                "\n0\n0\n",
            ball(5));
        Random r(11);
        int leaks = 0, met = 0;
        for (int i = 0; i < 4000; i++) {
            const Vec3 from = at + direction(r) * (place.scale * r.in(.1, 4.5));
            Ray ray = {to_float(from - scene.flat.centre), 0, to_float(direction(r)), FAR_AWAY};
            for (int b = 0; b < 8; b++) {
                Hit hit;
                Surface g;
                if (!scene.meet(ray, hit, g)) {
                    leaks++;
                    break;
                }
                met++;
                const Vec3 out = base::unit(to_double(g.ng) + direction(r) * .999);
                ray.org = offset_ray(g.p, g.ng, g.rounding);
                ray.dir = to_float(out);
            }
        }
        CAPTURE(place.scale);
        CAPTURE(place.move);
        CHECK(met > 30000);
        CHECK(leaks == 0);
    }
}
