// SPDX-License-Identifier: BSD-3-Clause
// Surfaces -> primitives, triangles and analytic shapes (spec: scene language 3).  Triangles and convex quads become
// triangles; every other polygon (holes by seams, concave) stays one shape with RADIANCE's even-odd inside test.
#include "flatten/surfaces.h"

#include <algorithm>
#include <fmt/core.h>

#include "base/error.h"
#include "flatten/coincident.h"
#include "flatten/evaluate.h"
#include "flatten/instances.h"
#include "flatten/pack.h"
#include "flatten/polygon.h"
#include "scene/materials.h"

namespace flatten {
namespace {

constexpr double TINY = 1e-6;  // FTINY of the reference
constexpr size_t MOST_PANES = 100000;

// The rectangle along the first edge that contains all corners.
Aperture rectangle_about(const std::vector<Vec3>& corners, Vec3 normal, Vec3 centre, bool both_sides) {
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

class SurfaceWriter {
public:
    SurfaceWriter(const scene::Scene& scene, const Modifiers* modifiers, Vec3 centre, Draft& out, Lights* lights)
        : scene_(scene), modifiers_(modifiers), centre_(centre), out_(out), lights_(lights) {}

    void add(const Object& o) {
        switch (o.type) {
        case Type::polygon: return add_polygon(o);
        case Type::sphere:
        case Type::bubble: return add_sphere(o);
        case Type::ring: return add_ring(o);
        default: return add_cone(o);
        }
    }

private:
    // Number of a new primitive; `tagged` with its class.
    uint32_t add_prim(const Object& o, uint32_t kind, Vec3 normal, uint32_t& tagged) {
        const uint32_t id = uint32_t(out_.prims.size());
        if (modifiers_ && modifiers_->is_clear(o.modifier)) kind |= PRIM_CLEAR;
        const uint32_t mod = modifiers_ ? modifiers_->record[o.modifier] : NONE;
        out_.prims.push_back({kind, mod, NONE, packed(normal), 0, 0});
        out_.prim_object.push_back(lights_ ? index_of(o) : inner_name(o));
        tagged = id;
        if (!modifiers_ || (!modifiers_->passes[o.modifier] && !hidden_[index_of(o)])) return id;
        tagged |= ID_TRANSPARENT;
        out_.shadows_need(SHADOW_STRAIGHT);
        return id;
    }
    uint32_t inner_name(const Object& o) {
        if (!out_.names) return FlatScene::NO_OBJECT;
        out_.inner_names.push_back({scene_.name(o), scene::type_name(o.type), scene_.place(o)});
        return uint32_t(out_.inner_names.size() - 1);
    }
    uint32_t add_curved_prim(const Object& o, uint32_t kind, const Shape& shape) {
        uint32_t tagged;
        const uint32_t prim = add_prim(o, kind, {}, tagged);
        out_.prims[prim].at = uint32_t(out_.shapes.size());
        out_.shapes.push_back(shape);
        out_.shape_prim.push_back(tagged);
        return prim;
    }
    void set_extent(uint32_t prim, double size, float offset = 0) {
        out_.prims[prim].kind |= extent_bits(size);
        out_.prims[prim].offset = offset;
    }

    uint32_t index_of(const Object& o) const { return uint32_t(&o - scene_.objects.data()); }
    void ignore(const Object& o, const char* what) const {
        base::warn(scene_.place(o), fmt::format("{}, surface ignored", what));
    }
    // ---- data for sources

    void note_emitter(const Object& o, uint32_t prim) {
        if (!lights_) return;
        const uint32_t m = modifiers_->material[o.modifier];
        if (m != NONE && scene::is_emissive(scene_.objects[m].type)) lights_->emitters.push_back({index_of(o), prim});
    }

    // Mirrors and prisms, also as the alternate of an illum, relay the light of sources (spec shading 4.6): polygons
    // and rings only.
    void note_relay(const Object& o, uint32_t prim, Vec3 normal, Vec3 middle, const std::vector<Vec3>& corners) {
        if (!lights_) return;
        int32_t modifier = o.modifier;
        uint32_t m = modifiers_->material[modifier];
        if (m != NONE && scene_.objects[m].type == Type::illum) {
            const auto names = scene_.strings(scene_.objects[m]);
            modifier = names.size() > 0 ? scene_.lookup_modifier(names[0], m) : scene::VOID;
            m = modifier >= 0 ? modifiers_->material[modifier] : NONE;
        }
        if (m == NONE) return;
        const Type t = scene_.objects[m].type;
        const int exits = t == Type::prism1 ? 1 : t == Type::prism2 ? 2 : 0;
        if (t != Type::mirror && !exits) return;
        const auto c = scene_.reals(scene_.objects[m]);
        const double reflectance = exits ? 1 : std::max(.01, (c[0] + c[1] + c[2]) / 3);
        lights_->relays.push_back({prim, normal, middle - centre_, exits,
                                   material_record(out_, modifiers_->record[modifier]), index_of(o), reflectance,
                                   rectangle_about(corners, normal, centre_, exits > 0)});
    }

    void warn_without_orientation(const Object& o, Vec3 p, Vec3 normal) {
        const uint32_t m = modifiers_->material[o.modifier];
        if (m == NONE) return;
        const Object& material = scene_.objects[m];
        if (material.type != Type::BSDF && material.type != Type::aBSDF) return;
        if (has_orientation(out_, material_record(out_, modifiers_->record[o.modifier]), p, normal)) return;
        base::warn(scene_.place(o), "the up vector of BSDF \"" + scene_.name(material) +
                                        "\" is 0 or along the surface's normal: the surface is black");
    }

    // ---- one function a kind

    void add_polygon(const Object& o) {
        const Polygon p(scene_.reals(o));
        if (p.area == 0) return ignore(o, "polygon of zero area");
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_FLAT | PRIM_TEXTURE_FLAT, p.normal, tagged);
        Vec3 mid;
        double radius = 0;
        for (const Vec3& v : p.corners) mid = mid + v * (1.0 / double(p.corners.size()));
        for (const Vec3& v : p.corners) radius = std::max(radius, length(v - mid));
        const bool triangles = p.is_triangles();
        std::vector<Vec3> corners = p.corners;
        for (Vec3& v : corners) v = v - centre_;
        if (triangles) {
            const Plane plane(p.normal, corners.data(), corners.size());
            set_extent(prim, plane.extent_of_triangles(corners.data(), corners.size()), plane.offset);
            add_triangles(corners, tagged);
        } else {
            set_extent(prim, 2 * radius, float(p.offset(centre_)));
            add_outline(p, corners, 2.4e-7 * (3 * radius + length(mid - centre_)), tagged);
        }
        note_emitter(o, prim);
        note_relay(o, prim, p.normal, mid, p.corners);
        if (modifiers_) warn_without_orientation(o, mid - centre_, p.normal);
        if (lights_ && modifiers_->passes[o.modifier] && out_.panes.size() < MOST_PANES)
            out_.panes.push_back({p.corners[0], p.corners[1] - p.corners[0], p.normal, p.area, p.corners});
    }

    // corners: relative to the centre
    void add_triangles(const std::vector<Vec3>& corners, uint32_t tagged) {
        const uint32_t first = uint32_t(out_.vertices.size() / 3 - first_vertex_);
        for (const Vec3& q : corners) out_.vertices.insert(out_.vertices.end(), {float(q.x), float(q.y), float(q.z)});
        for (uint32_t i = 1; i + 1 < corners.size(); i++) {
            out_.triangles.insert(out_.triangles.end(), {first, first + i, first + i + 1});
            out_.tri_prim.push_back(tagged);
        }
    }

    // The corners projected to the coordinate plane that the polygon faces most.
    void add_outline(const Polygon& p, const std::vector<Vec3>& corners, double margin, uint32_t tagged) {
        const Vec3 n = p.normal;
        const int drop = p.axis();
        const uint32_t at = uint32_t(out_.polygon_uv.size()), count = uint32_t(corners.size());
        for (int axis : {drop == 0 ? 1 : 0, drop == 2 ? 1 : 2}) {
            const size_t row = out_.polygon_uv.size();
            out_.polygon_uv.push_back(float(corners.back()[axis]));
            for (const Vec3& v : corners) out_.polygon_uv.push_back(float(v[axis]));
            out_.polygon_uv.resize(row + POLYGON_ROW(count), NAN);
        }
        Shape shape{};
        shape.kind = SHAPE_POLYGON;
        shape.normal = packed(n);
        shape.offset = float(p.offset(centre_));
        shape.margin = float(margin);
        shape.dropped_axis = uint32_t(drop);
        shape.uv_at = at;
        shape.corners = count;
        out_.shapes.push_back(shape);
        out_.shape_prim.push_back(tagged);
    }

    void add_sphere(const Object& o) {
        const auto r = scene_.reals(o);
        const bool inward = (o.type == Type::bubble) != (r[3] < 0);
        const Vec3 c = vec_at(r, 0) - centre_;
        Shape shape{};
        shape.kind = SHAPE_SPHERE;
        shape.centre = packed(c);
        shape.radius = float(std::fabs(r[3]));
        const uint32_t prim = add_curved_prim(o, PRIM_SPHERE | (inward ? PRIM_INWARD : 0u), shape);
        set_extent(prim, 2 * std::fabs(r[3]));
        note_emitter(o, prim);
    }

    void add_cone(const Object& o) {
        const auto r = scene_.reals(o);
        const bool straight = o.type == Type::cylinder || o.type == Type::tube;
        double r0 = r[6], r1 = straight ? r[6] : r[7];
        bool inward = o.type == Type::cup || o.type == Type::tube;
        if (r0 * r1 < 0) return ignore(o, "cone radii of opposite sign");
        if (r0 < 0 || r1 < 0) {
            inward = !inward;
            r0 = std::fabs(r0);
            r1 = std::fabs(r1);
        }
        if (r0 <= TINY && r1 <= TINY) return ignore(o, "radius too small");
        const Vec3 p0 = vec_at(r, 0) - centre_, axis = vec_at(r, 3) - vec_at(r, 0);
        const double len = length(axis);
        if (len <= TINY) return ignore(o, "axis of zero length");
        Shape shape{};
        shape.kind = SHAPE_CONE;
        shape.centre = packed(p0);
        shape.normal = packed({axis.x / len, axis.y / len, axis.z / len});
        shape.length = float(len);
        shape.radius = float(r0), shape.other_radius = float(r1);
        const uint32_t prim = add_curved_prim(o, PRIM_CONE | (inward ? PRIM_INWARD : 0u), shape);
        set_extent(prim, len + 2 * std::max(r0, r1));
        note_emitter(o, prim);
    }

    void add_ring(const Object& o) {
        const auto r = scene_.reals(o);
        const Vec3 n = vec_at(r, 3);
        const double r0 = std::min(r[6], r[7]), r1 = std::max(r[6], r[7]);
        if (length(n) <= TINY) return ignore(o, "ring with zero normal");
        if (r0 < 0 || r1 - r0 <= TINY) return ignore(o, "bad ring radii");
        const Vec3 c = vec_at(r, 0) - centre_, u = unit(n);
        Shape shape{};
        shape.kind = SHAPE_RING;
        shape.centre = packed(c);
        shape.normal = packed(u);
        shape.radius = float(r1), shape.other_radius = float(r0);
        out_.shapes.push_back(shape);
        uint32_t tagged;
        const uint32_t prim = add_prim(o, PRIM_FLAT | PRIM_TEXTURE_FLAT, u, tagged);
        out_.shape_prim.push_back(tagged);
        note_emitter(o, prim);
        set_extent(prim, 2 * r1, Plane(u, &c, 1).offset);
        const Vec3 mid = vec_at(r, 0), across = std::fabs(u.z) < 0.9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0};
        const Vec3 a = unit(cross(u, across)) * r1, b = cross(u, a);
        note_relay(o, prim, u, mid, {mid - a - b, mid + a - b, mid + a + b, mid - a + b});
    }

    const scene::Scene& scene_;
    const Modifiers* modifiers_;
    const Vec3 centre_;
    Draft& out_;
    Lights* lights_;
    const std::vector<uint8_t> hidden_ = modifiers_ ? hidden_by_passing(*modifiers_, centre_) : std::vector<uint8_t>();
    const size_t first_vertex_ = out_.vertices.size() / 3;
};

}  // namespace

// The common case: polygons of three or four corners.
static void make_room_for_polygons(const scene::Scene& scene, Draft& out) {
    size_t polygons = 0, corners = 0;
    for (const Object& o : scene.objects) {
        if (o.type != Type::polygon || o.real_count > 12) continue;
        polygons++;
        corners += o.real_count / 3;
    }
    out.make_room(corners, corners - 2 * polygons, polygons);
}

void flatten_surfaces(const scene::Scene& scene, const Modifiers* modifiers, Vec3 centre, const base::WorkBudget& work,
                      Draft& out, Lights* lights) {
    constexpr size_t objects_a_check = 4096;  // some milliseconds
    make_room_for_polygons(scene, out);
    SurfaceWriter writer(scene, modifiers, centre, out, lights);
    for (const Object& o : scene.objects) {
        if (size_t(&o - scene.objects.data()) % objects_a_check == 0) work.check();
        if (!scene::is_surface(o.type) || o.type == Type::source || o.type == Type::mesh || o.type == Type::instance)
            continue;
        // rays pass a chain without material
        if (modifiers && (o.modifier < 0 || !modifiers->is_met[o.modifier])) continue;
        writer.add(o);
    }
}

}  // namespace flatten
