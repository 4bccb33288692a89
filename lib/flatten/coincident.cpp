// SPDX-License-Identifier: BSD-3-Clause
// See coincident.h.  Faces are sorted by plane, then along one axis: n log n time, and a limited number of pairs.
#include "flatten/coincident.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <map>
#include <optional>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "flatten/host_tracer.h"
#include "flatten/pack.h"
#include "flatten/polygon.h"
#include "flatten/surfaces.h"
#include "scene/materials.h"

namespace flatten {
namespace {

constexpr size_t MOST_PAIRS = 4000000;
constexpr int GRID = 8;                // points tested along each side of the intersection of two faces
constexpr double LARGE = 1e-3;         // side of a square, in radii of the scene
constexpr double SAME_PLANE = 9.5e-7;  // 2^-20 of the radius

struct Face {
    const scene::Object* object;
    std::array<int, 3> direction;  // of the plane
    double offset;
    int u, v;     // axes across
    bool turned;  // it faces the opposite of `direction`
    double low[2], high[2];
    std::vector<Vec3> corners;

    bool holds(double x, double y) const {
        bool odd = false;
        for (size_t i = 0, k = corners.size() - 1; i < corners.size(); k = i++) {
            const Vec3 &p = corners[k], &q = corners[i];
            if ((p[v] > y) != (q[v] > y) && x < (q[u] - p[u]) * (y - p[v]) / (q[v] - p[v]) + p[u]) odd = !odd;
        }
        return odd;
    }
};

Face face_of(const scene::Object& o, std::vector<Vec3> corners, Vec3 normal) {
    Face f{&o, {}, 0, 0, 0, false, {1e30, 1e30}, {-1e30, -1e30}, std::move(corners)};
    int main = 0;
    for (int k = 1; k < 3; k++)
        if (std::fabs(normal[k]) > std::fabs(normal[main]) + 1e-6) main = k;
    f.turned = normal[main] < 0;
    if (f.turned) normal = normal * -1;
    for (int k = 0; k < 3; k++) f.direction[k] = int(std::lround(normal[k] * 4096));
    f.u = main == 0 ? 1 : 0;
    f.v = main == 2 ? 1 : 2;
    for (const Vec3& p : f.corners) {
        f.offset += dot(p, normal) / double(f.corners.size());
        for (int k = 0; k < 2; k++) {
            f.low[k] = std::min(f.low[k], p[k ? f.v : f.u]);
            f.high[k] = std::max(f.high[k], p[k ? f.v : f.u]);
        }
    }
    return f;
}

// Returns true for a visible surface of a flat type.
bool is_face(const Modifiers& modifiers, const scene::Object& o) {
    return (o.type == Type::polygon || o.type == Type::ring) && o.modifier >= 0 && modifiers.is_met[o.modifier];
}

// Groups large faces by their planes; coordinates are relative to the centre.
std::vector<Face> faces_of(const Modifiers& modifiers, Vec3 centre, double large) {
    std::vector<Face> faces;
    for (const scene::Object& o : modifiers.scene.objects) {
        if (!is_face(modifiers, o)) continue;
        const auto r = modifiers.scene.reals(o);
        std::vector<Vec3> corners;
        Vec3 normal;
        if (o.type == Type::polygon) {
            const Polygon polygon(r);
            corners = polygon.corners;
            normal = polygon.normal;
        } else {
            normal = vec_at(r, 3);
        }
        if (!(length(normal) > 0)) continue;
        normal = base::unit(normal);
        if (o.type == Type::ring) {
            const Vec3 a = base::unit(cross(normal, std::fabs(normal.z) < .9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
            for (int k = 0; k < 24; k++)
                corners.push_back(vec_at(r, 0) +
                                  (a * std::cos(k * .2617994) + cross(normal, a) * std::sin(k * .2617994)) *
                                      std::max(r[6], r[7]));
        }
        for (Vec3& p : corners) p = p - centre;
        Face face = face_of(o, std::move(corners), normal);
        if (std::min(face.high[0] - face.low[0], face.high[1] - face.low[1]) >= large) faces.push_back(std::move(face));
    }
    std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) {
        return std::tie(a.direction, a.offset) < std::tie(b.direction, b.offset);
    });
    return faces;
}

// A point in both faces, from a grid over the intersection of their boxes, if that is large; else null.
bool cover(const Face& a, const Face& b, double large, Vec3& where) {
    double low[2], size[2];
    for (int k = 0; k < 2; k++) {
        low[k] = std::max(a.low[k], b.low[k]);
        size[k] = std::min(a.high[k], b.high[k]) - low[k];
        if (!(size[k] >= large)) return false;
    }
    for (int k = 0; k < GRID * GRID; k++) {
        const double x = low[0] + size[0] * (k % GRID + .5) / GRID, y = low[1] + size[1] * (k / GRID + .5) / GRID;
        if (!a.holds(x, y) || !b.holds(x, y)) continue;
        where = a.corners[0];
        (a.u == 0 ? where.x : where.y) = x;
        (a.v == 1 ? where.y : where.z) = y;
        return true;
    }
    return false;
}

// Calls each(a, b, where) for all overlapping a and b of one plane, with a point in the middle of their overlap.
template <class Each>
void of_pairs(std::vector<Face>& faces, double near, double large, const Each& each) {
    size_t pairs = 0;
    Vec3 where;
    for (size_t from = 0, to; from < faces.size() && pairs < MOST_PAIRS; from = to) {
        for (to = from + 1; to < faces.size() && faces[to].direction == faces[from].direction &&
                            faces[to].offset - faces[to - 1].offset <= near;)
            to++;
        std::sort(&faces[from], &faces[from] + (to - from),
                  [](const Face& a, const Face& b) { return a.low[0] < b.low[0]; });
        for (size_t i = from; i < to; i++)
            for (size_t k = i + 1; k < to && faces[k].low[0] < faces[i].high[0] && pairs++ < MOST_PAIRS; k++)
                if (faces[i].object->modifier != faces[k].object->modifier && cover(faces[i], faces[k], large, where))
                    each(faces[i], faces[k], where);
    }
}

// Kind: 1 ball, 2 tube, 3 cone, 0 other types; two coincide if kind and numbers are equal.
int curved_kind(Type t) {
    if (t == Type::sphere || t == Type::bubble) return 1;
    if (t == Type::cylinder || t == Type::tube) return 2;
    return t == Type::cone || t == Type::cup ? 3 : 0;
}
std::vector<double> curved_key(const scene::Scene& scene, const scene::Object& o) {
    std::vector<double> key = {double(curved_kind(o.type))};
    const auto r = scene.reals(o);
    for (size_t i = 0; i < r.size(); i++) key.push_back(r[i]);
    return key;
}

// Returns true if shadow rays pass it although it may hide an opaque surface.
bool passes_and_hides(const Modifiers& modifiers, const scene::Object& o) {
    return o.modifier >= 0 && modifiers.is_met[o.modifier] && modifiers.passes[o.modifier] &&
           !modifiers.is_clear(o.modifier);
}

// Returns true if `over` hides the opaque surface in its place from some side.  turned: they face opposite ways.
bool hides(const Modifiers& modifiers, const scene::Object& over, const scene::Object& opaque, bool turned) {
    if (!passes_and_hides(modifiers, over) || modifiers.passes[opaque.modifier]) return false;
    const uint32_t m = modifiers.material[opaque.modifier];
    if (m != NONE && scene::is_emissive(modifiers.scene.objects[m].type)) return false;  // Source.covered
    return turned || modifiers.record[over.modifier] > modifiers.record[opaque.modifier];
}

// One of 16 points on a curved light source, and the normal there.
struct OnLamp {
    Vec3 point, normal;
};
OnLamp on_round_lamp(const Source& q, uint32_t k) {
    const double angle = 2.4 * k, height = (k + .5) / 8 - 1;
    if (q.kind == SK_SPHERE) {
        const double across = std::sqrt(1 - height * height);
        const Vec3 n = {across * std::cos(angle), across * std::sin(angle), height};
        return {vec_of(q.centre) + n * double(q.radius), n};
    }
    const Vec3 half = vec_of(q.u), a = base::unit(half);
    const Vec3 b = base::unit(cross(a, std::fabs(a.z) < .9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0}));
    const Vec3 n = b * std::cos(angle) + cross(a, b) * std::sin(angle);
    return {vec_of(q.centre) + half * height + n * double(q.radius), n};
}

}  // namespace

void warn_of_coincident(const Modifiers& modifiers, const FlatScene& scene) {
    const double near = SAME_PLANE * scene.radius, large = LARGE * scene.radius;
    std::vector<Face> faces = faces_of(modifiers, scene.centre, large);
    size_t count = 0;
    const Face* first[2] = {nullptr, nullptr};
    Vec3 place;
    of_pairs(faces, near, large, [&](const Face& a, const Face& b, Vec3 where) {
        // of two faces with opposite normals each is visible from its own side: a house on its ground
        if (a.turned != b.turned || count++ > 0) return;
        first[0] = &a, first[1] = &b, place = where + scene.centre;
        if (first[0]->object > first[1]->object) std::swap(first[0], first[1]);
    });
    if (count == 0) return;
    const scene::Scene& s = modifiers.scene;
    const scene::Object* of[2];
    for (int k = 0; k < 2; k++) of[k] = &s.objects[size_t(first[k]->object->modifier)];
    const auto name = [&](int k) {  // one name may stand for several modifiers
        const std::string quoted = fmt::format("\"{}\"", s.name(*of[k]));
        return s.name(*of[0]) == s.name(*of[1]) ? fmt::format("{} ({})", quoted, s.place(*of[k])) : quoted;
    };
    base::warn(s.place(*first[1]->object),
               fmt::format("{} of large faces with different modifiers {} in the same place, first {} and {} about "
                           "{:.4g} {:.4g} {:.4g}: an opaque one hides a transparent one, then one that faces the eye "
                           "the other, then that of the later modifier",
                           count == 1 ? "one pair" : fmt::format("{} pairs", count), count == 1 ? "lies" : "lie",
                           name(0), name(1), place.x, place.y, place.z));
}

std::vector<uint8_t> hidden_by_passing(const Modifiers& modifiers, Vec3 centre) {
    const std::vector<scene::Object>& objects = modifiers.scene.objects;
    std::vector<uint8_t> hidden(objects.size(), 0);
    const auto one = [&](const scene::Object& o) {
        return scene::is_surface(o.type) && passes_and_hides(modifiers, o);
    };
    if (std::none_of(objects.begin(), objects.end(), one)) return hidden;
    const auto look = [&](const scene::Object& a, const scene::Object& b, bool turned) {
        if (hides(modifiers, a, b, turned)) hidden[size_t(&b - objects.data())] = 1;
        if (hides(modifiers, b, a, turned)) hidden[size_t(&a - objects.data())] = 1;
    };
    std::vector<Face> faces = faces_of(modifiers, centre, 0);
    double size = 0;
    for (const Face& f : faces)
        size = std::max({size, std::fabs(f.offset), f.high[0] - f.low[0], f.high[1] - f.low[1]});
    of_pairs(faces, SAME_PLANE * size, 0,
             [&](const Face& a, const Face& b, Vec3) { look(*a.object, *b.object, a.turned != b.turned); });

    std::map<std::vector<double>, std::vector<const scene::Object*>> curved;
    for (const scene::Object& o : objects)
        if (curved_kind(o.type) != 0 && o.modifier >= 0 && modifiers.is_met[o.modifier])
            curved[curved_key(modifiers.scene, o)].push_back(&o);
    for (const auto& [key, twins] : curved)
        for (size_t i = 1; i < twins.size(); i++)
            for (size_t k = 0; k < i; k++) look(*twins[k], *twins[i], twins[k]->type != twins[i]->type);
    return hidden;
}

void mark_covered_sources(FlatScene& scene) {
    constexpr uint32_t side = 4;
    std::optional<HostTracer> tracer;
    for (uint32_t i = 0; i < scene.sources.size(); i++) {
        Source& q = scene.sources[i];
        const uint32_t kind = q.kind;
        if (q.relay != NONE || kind == SK_DISTANT) continue;
        const bool round = kind == SK_SPHERE || kind == SK_CYLINDER;
        if (!tracer) tracer.emplace(scene);
        Vec3 normal = vec_of(q.normal);
        const Vec3 centre = vec_of(q.centre) + scene.centre;
        const double size = std::sqrt(double(q.area));
        const double near = std::ldexp(scene.radius + length(vec_of(q.centre)), -18);
        for (uint32_t k = 0; k < side * side; k++) {
            Vec3 point;
            if (round) {
                const OnLamp on = on_round_lamp(q, k);
                point = on.point + scene.centre, normal = on.normal;
            } else {
                const Vec3 eye = centre + normal * size;
                const auto at = tracer->source_point(i, eye, (k % side + .5) / side, (k / side + .5) / side);
                if (!(at.solid_angle > 0)) continue;
                point = eye + at.dir * at.dist;
            }
            const auto met = tracer->closest(point + normal * near, normal * -1, 0, 2 * near, HostTracer::all);
            if (met.t < 0 || met.prim == q.prim) continue;
            q.covered = 1;
            break;
        }
    }
}

}  // namespace flatten
