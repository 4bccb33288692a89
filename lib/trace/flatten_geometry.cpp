// SPDX-License-Identifier: BSD-3-Clause
// Surfaces -> primitives, triangles and analytic shapes (spec: scene language 3).  Triangles and convex quads become
// triangles; every other polygon (holes by seams, concave) stays one shape with RADIANCE's even-odd inside test.
#include <algorithm>
#include <cmath>
#include <fmt/core.h>

#include "base/error.h"
#include "scene/materials.h"
#include "trace/flatten.h"

namespace trace {
namespace {
using namespace kernels;
using base::Vec3;
using scene::Type;

constexpr double TINY = 1e-6;  // FTINY of the reference
constexpr uint32_t TRANSPARENT_BIT = 0x80000000u;

Vec3 vec_at(const scene::Span<double>& r, size_t i) { return {r[i], r[i + 1], r[i + 2]}; }

struct Builder {
    Flattener& f;  // its modifiers
    const scene::Scene& scene;
    FlatScene& out;
    const Vec3 centre;  // of the tree
    const Owner owner;
    const size_t first_vertex = out.vertices.size() / 3;

    uint32_t add_prim(const scene::Object& o, uint32_t kind, Vec3 normal, uint32_t shape, uint32_t& tagged) {
        const uint32_t id = uint32_t(out.prims.size() / PRIM_WORDS);
        const bool own = owner != Owner::replaced;
        uint32_t rec[PRIM_WORDS] = {kind,
                                    own ? f.mod_of[o.modifier] : NONE,
                                    NONE,
                                    bits(float(normal.x)),
                                    bits(float(normal.y)),
                                    bits(float(normal.z)),
                                    0,
                                    0};
        if ((kind & PRIM_KIND_MASK) == PRIM_SPHERE || (kind & PRIM_KIND_MASK) == PRIM_CONE) rec[PRIM_NORMAL] = shape;
        out.prims.insert(out.prims.end(), rec, rec + PRIM_WORDS);
        out.prim_object.push_back(owner == Owner::scene ? uint32_t(&o - scene.objects.data()) : FlatScene::NO_OBJECT);
        const bool pass = own && f.passes[o.modifier];
        tagged = id | (pass ? TRANSPARENT_BIT : 0u);
        if (pass) out.shadow_mode = SHADOW_STRAIGHT;
        return id;
    }
    uint32_t add_shape(uint32_t kind, std::initializer_list<double> values) {
        const uint32_t id = uint32_t(out.shapes.size() / 16);
        out.shapes.resize(out.shapes.size() + 16, 0.0f);
        float* q = &out.shapes[16 * id];
        q[0] = from_bits(kind);
        int i = 1;
        for (double v : values) q[i++] = float(v);
        return id;
    }
    uint32_t add_vertex(Vec3 p) {
        p = p - centre;
        out.vertices.insert(out.vertices.end(), {float(p.x), float(p.y), float(p.z)});
        return uint32_t(out.vertices.size() / 3 - 1 - first_vertex);
    }
    void warn(const scene::Object& o, const char* what) {
        base::warn(scene.place(o), fmt::format("{}, surface ignored", what));
    }
    void emit(const scene::Object& o, uint32_t prim) {
        if (owner != Owner::scene) return;
        const uint32_t m = f.material_of[o.modifier];
        if (m == NONE) return;
        if (scene::shines(scene.objects[m].type)) f.emitters.push_back({uint32_t(&o - scene.objects.data()), prim});
    }

    // The rectangle along the first edge that holds all corners.
    Flattener::Gate rectangle_about(const std::vector<Vec3>& corners, Vec3 normal, bool both_sides) const {
        const Vec3 u = unit(corners[1] - corners[0]), v = cross(normal, u), origin = corners[0];
        double low[2] = {0, 0}, high[2] = {0, 0};
        for (const Vec3& c : corners)
            for (int k = 0; k < 2; k++) {
                const double at = dot(c - origin, k ? v : u);
                low[k] = std::min(low[k], at);
                high[k] = std::max(high[k], at);
            }
        const Vec3 middle = origin + u * ((low[0] + high[0]) / 2) + v * ((low[1] + high[1]) / 2);
        return {middle - centre, normal, u * (2 / (high[0] - low[0])), v * (2 / (high[1] - low[1])), both_sides};
    }

    // Mirrors and prisms, also as the alternate of an illum, relay the light of sources (spec shading 4.6): polygons
    // and rings only.
    void relay(const scene::Object& o, uint32_t prim, Vec3 normal, Vec3 middle, const std::vector<Vec3>& corners) {
        if (owner != Owner::scene) return;
        int32_t modifier = o.modifier;
        uint32_t m = f.material_of[modifier];
        if (m != NONE && scene.objects[m].type == Type::illum) {
            const auto names = scene.strings(scene.objects[m]);
            modifier = names.size() > 0 ? scene.lookup_modifier(names[0], m) : scene::VOID;
            m = modifier >= 0 ? f.material_of[modifier] : NONE;
        }
        if (m == NONE) return;
        const Type t = scene.objects[m].type;
        const int exits = t == Type::prism1 ? 1 : t == Type::prism2 ? 2 : 0;
        if (t != Type::mirror && !exits) return;
        const uint32_t material = f.material_record(f.mod_of[modifier]), object = uint32_t(&o - scene.objects.data());
        const auto c = scene.reals(scene.objects[m]);
        const double reflectance = exits ? 1 : std::max(.01, (c[0] + c[1] + c[2]) / 3);
        f.relays.push_back({prim, normal, middle - centre, exits, material, object, reflectance,
                            rectangle_about(corners, normal, exits > 0)});
    }

    void polygon(const scene::Object& o) {
        const auto r = scene.reals(o);
        size_t n = r.size() / 3;
        std::vector<Vec3> v(n);
        for (size_t i = 0; i < n; i++) v[i] = vec_at(r, 3 * i);
        if (n > 3 && length(v[0] - v[n - 1]) <= TINY) v.resize(--n);
        Vec3 sum;  // Newell
        for (size_t i = 1; i + 1 < n; i++) sum = sum + cross(v[i] - v[0], v[i + 1] - v[0]);
        const double area2 = length(sum);
        if (area2 == 0) return warn(o, "polygon of zero area");
        const Vec3 normal = sum * (1 / area2);
        bool convex = n == 3;
        if (n == 4) {
            convex = true;
            for (int i = 0; i < 4; i++)
                convex = convex && dot(cross(v[(i + 1) % 4] - v[i], v[(i + 2) % 4] - v[(i + 1) % 4]), normal) > 0;
            // a bent quad keeps the reference's mean plane
            for (int i = 1; i < 4; i++)
                convex =
                    convex && std::fabs(dot(v[i] - v[0], normal)) <= 1e-5 * std::max(1.0, std::fabs(dot(v[0], normal)));
        }
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_FLAT | PRIM_TEXTURE_FLAT, normal, 0, tagged);
        if (convex) {
            uint32_t first = 0;
            for (size_t i = 0; i < n; i++) {
                const uint32_t at = add_vertex(v[i]);
                if (!i) first = at;
            }
            for (uint32_t i = 1; i + 1 < n; i++) {
                out.triangles.insert(out.triangles.end(), {first, first + i, first + i + 1});
                out.tri_prim.push_back(tagged);
            }
        } else {
            double offset = 0;
            for (const Vec3& p : v) offset += dot(p - centre, normal);
            offset /= double(n);
            const double a[3] = {std::fabs(normal.x), std::fabs(normal.y), std::fabs(normal.z)};
            const int drop = a[0] > a[1] ? (a[0] > a[2] ? 0 : 2) : (a[1] > a[2] ? 1 : 2);
            const uint32_t at = uint32_t(out.polygon_uv.size() / 2);
            for (const Vec3& p : v) {
                const Vec3 q = p - centre;
                out.polygon_uv.push_back(float(q[drop == 0 ? 1 : 0]));
                out.polygon_uv.push_back(float(q[drop == 2 ? 1 : 2]));
            }
            const uint32_t shape = add_shape(SHAPE_POLYGON, {normal.x, normal.y, normal.z, offset});
            out.shapes[16 * shape + 5] = from_bits(uint32_t(drop));
            out.shapes[16 * shape + 6] = from_bits(at);
            out.shapes[16 * shape + 7] = from_bits(uint32_t(n));
            out.shape_prim.push_back(tagged);
        }
        emit(o, prim);
        Vec3 mid;
        double radius = 0;
        for (const Vec3& p : v) mid = mid + p * (1.0 / double(n));
        for (const Vec3& p : v) radius = std::max(radius, length(p - mid));
        out.prims[PRIM_WORDS * prim + PRIM_EXTENT] = bits(float(2 * radius));
        relay(o, prim, normal, mid, v);
        if (owner == Owner::scene && f.passes[o.modifier] && out.panes.size() < 100000)
            out.panes.push_back({v[0], v[1] - v[0], normal, area2 / 2, v});
    }

    void sphere(const scene::Object& o) {
        const auto r = scene.reals(o);
        const bool inward = (o.type == Type::bubble) != (r[3] < 0);
        const Vec3 c = vec_at(r, 0) - centre;
        const uint32_t shape = add_shape(SHAPE_SPHERE, {c.x, c.y, c.z, std::fabs(r[3])});
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_SPHERE | (inward ? PRIM_INWARD : 0u), {}, shape, tagged);
        out.shape_prim.push_back(tagged);
        out.prims[PRIM_WORDS * prim + PRIM_EXTENT] = bits(float(2 * std::fabs(r[3])));
        emit(o, prim);
    }

    void cone(const scene::Object& o) {
        const auto r = scene.reals(o);
        const bool straight = o.type == Type::cylinder || o.type == Type::tube;
        double r0 = r[6], r1 = straight ? r[6] : r[7];
        bool inward = o.type == Type::cup || o.type == Type::tube;
        if (r0 * r1 < 0) return warn(o, "cone radii of opposite sign");
        if (r0 < 0 || r1 < 0) {
            inward = !inward;
            r0 = std::fabs(r0);
            r1 = std::fabs(r1);
        }
        if (r0 <= TINY && r1 <= TINY) return warn(o, "radius too small");
        const Vec3 p0 = vec_at(r, 0) - centre, axis = vec_at(r, 3) - vec_at(r, 0);
        const double len = length(axis);
        if (len <= TINY) return warn(o, "axis of zero length");
        const uint32_t shape =
            add_shape(SHAPE_CONE, {p0.x, p0.y, p0.z, axis.x / len, axis.y / len, axis.z / len, len, r0, r1});
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_CONE | (inward ? PRIM_INWARD : 0u), {}, shape, tagged);
        out.shape_prim.push_back(tagged);
        out.prims[PRIM_WORDS * prim + PRIM_EXTENT] = bits(float(2 * std::max(r0, r1)));
        emit(o, prim);
    }

    void ring(const scene::Object& o) {
        const auto r = scene.reals(o);
        const Vec3 n = vec_at(r, 3);
        const double r0 = std::min(r[6], r[7]), r1 = std::max(r[6], r[7]);
        if (length(n) <= TINY) return warn(o, "ring with zero normal");
        if (r0 < 0 || r1 - r0 <= TINY) return warn(o, "bad ring radii");
        const Vec3 c = vec_at(r, 0) - centre, u = unit(n);
        add_shape(SHAPE_RING, {c.x, c.y, c.z, u.x, u.y, u.z, r0, r1});
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_FLAT | PRIM_TEXTURE_FLAT, u, 0, tagged);
        out.shape_prim.push_back(tagged);
        emit(o, prim);
        out.prims[PRIM_WORDS * prim + PRIM_EXTENT] = bits(float(2 * r1));
        const Vec3 mid = vec_at(r, 0), across = std::fabs(u.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
        const Vec3 a = unit(cross(u, across)) * r1, b = cross(u, a);
        relay(o, prim, u, mid, {mid - a - b, mid + a - b, mid + a + b, mid - a + b});
    }
};

}  // namespace

void grow(Box& box, Vec3 p) {
    for (int k = 0; k < 3; k++) {
        box.lo[k] = std::min(box.lo[k], p[k]);
        box.hi[k] = std::max(box.hi[k], p[k]);
    }
}

// Near the origin the scene's own coordinates are kept.
Vec3 centre_of(const Box& box) {
    if (box.lo.x > box.hi.x) return {};
    const Vec3 mid = (box.lo + box.hi) * 0.5;
    if (length(mid) <= length(box.hi - box.lo)) return {};
    return {std::round(mid.x), std::round(mid.y), std::round(mid.z)};
}

Box surface_bounds(const scene::Scene& s) {
    Box box;
    for (const scene::Object& o : s.objects) {
        if (!scene::is_surface(o.type) || o.type == Type::source || o.type == Type::mesh || o.type == Type::instance)
            continue;
        const auto r = s.reals(o);
        const size_t points = o.type == Type::polygon                                                    ? r.size() / 3
                              : o.type == Type::sphere || o.type == Type::bubble || o.type == Type::ring ? 1
                                                                                                         : 2;
        const double round = o.type == Type::polygon || r.size() < 4 ? 0
                             : points == 2          ? std::max(std::fabs(r[6]), r.size() > 7 ? std::fabs(r[7]) : 0)
                             : o.type == Type::ring ? std::max(r[6], r[7])
                                                    : std::fabs(r[3]);
        for (size_t i = 0; i < points && 3 * i + 2 < r.size(); i++) {
            const Vec3 p = vec_at(r, 3 * i), d{round, round, round};
            if (!within_reach(p) || !(round < farthest)) base::fail(s.place(o), "a coordinate is beyond 1e18");
            grow(box, p - d);
            grow(box, p + d);
        }
    }
    return box;
}

void flatten_surfaces(Flattener& f, const scene::Scene& scene, Vec3 centre, Owner owner) {
    Builder b{f, scene, f.out, centre, owner};
    for (const scene::Object& o : scene.objects) {
        if (!scene::is_surface(o.type) || o.type == Type::source || o.type == Type::mesh || o.type == Type::instance)
            continue;
        // a chain without material lets rays pass
        if (owner != Owner::replaced && (o.modifier < 0 || !f.has_material[o.modifier])) continue;
        switch (o.type) {
        case Type::polygon: b.polygon(o); break;
        case Type::sphere:
        case Type::bubble: b.sphere(o); break;
        case Type::ring: b.ring(o); break;
        default: b.cone(o);
        }
    }
}

}  // namespace trace
