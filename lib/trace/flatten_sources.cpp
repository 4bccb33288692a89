// SPDX-License-Identifier: BSD-3-Clause
// Which emitters are active sources (spec shading 4.1) and their records; the distant surfaces in order; the cumulative
// power table.  Everything else that glows is found by sampled rays alone.
#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/core.h>
#include <map>
#include <set>

#include "base/error.h"
#include "scene/materials.h"
#include "trace/flatten.h"
#include "trace/host_tracer.h"

namespace trace {
namespace {
using namespace kernels;
using base::Vec3;
using scene::Type;

constexpr double PI = 3.14159265358979323846;
Vec3 vec_at(const scene::Span<double>& r, size_t i) { return {r[i], r[i + 1], r[i + 2]}; }
double luminance_weight(const scene::Span<double>& c) {
    return .265074126 * c[0] + .670114631 * c[1] + .064811243 * c[2];
}

void put(float* q, Vec3 v) {
    q[0] = float(v.x);
    q[1] = float(v.y);
    q[2] = float(v.z);
}

// Ear clipping of a simple polygon in its plane; the fan's triangles by vertex index.  Falls back to a fan.
std::vector<std::array<int, 3>> triangulate(const std::vector<Vec3>& v, Vec3 n) {
    std::vector<std::array<int, 3>> out;
    std::vector<int> left(v.size());
    for (size_t i = 0; i < v.size(); i++) left[i] = int(i);
    const auto turn = [&](int a, int b, int c) { return dot(cross(v[b] - v[a], v[c] - v[b]), n); };
    while (left.size() > 3) {
        bool clipped = false;
        for (size_t i = 0; i < left.size() && !clipped; i++) {
            const int a = left[(i + left.size() - 1) % left.size()], b = left[i], c = left[(i + 1) % left.size()];
            if (turn(a, b, c) <= 0) continue;
            bool empty = true;
            for (int k : left) {
                if (v[k] == v[a] || v[k] == v[b] || v[k] == v[c]) continue;
                const auto inside = [&](int s, int e) { return dot(cross(v[e] - v[s], v[k] - v[s]), n) >= 0; };
                if (inside(a, b) && inside(b, c) && inside(c, a)) {
                    empty = false;
                    break;
                }
            }
            if (!empty) continue;
            out.push_back({a, b, c});
            left.erase(left.begin() + long(i));
            clipped = true;
        }
        if (!clipped) {  // degenerate: drop a vertex of no area
            left.erase(left.begin());
        }
    }
    out.push_back({left[0], left[1], left[2]});
    return out;
}
// The half vectors of RADIANCE's partition: quadrilaterals as if parallelograms, triangles by the edge nearest the
// centroid, others a square of equal area.
void size_vectors(const std::vector<Vec3>& v, Vec3 mid, Vec3 n, double area, Vec3& u, Vec3& w) {
    if (v.size() == 4) {
        u = (v[1] - v[0]) * 0.5;
        w = (v[3] - v[0]) * 0.5;
        return;
    }
    Vec3 along = unit(v[1] - v[0]);
    double size = std::sqrt(area) / 2;
    if (v.size() == 3) {
        size = 1e30;
        for (int i = 0; i < 3; i++) {
            const Vec3 e = unit(v[(i + 1) % 3] - v[i]);
            const double d = length(cross(mid - v[i], e));
            if (d < size) {
                size = d;
                along = e;
            }
        }
    }
    u = along * size;
    w = cross(n, along) * size;
}
}  // namespace

// "relay>relay>source": the way back from the point lit.
bool Flattener::source_is_called(const std::vector<float>& records, const std::vector<uint32_t>& source_objects,
                                 uint32_t i, std::string_view name) const {
    for (uint32_t way; (way = bits(records[i * SOURCE_FLOATS + SRC_VIRTUAL])) != NONE; i = out.u[way + RELAY_SOURCE]) {
        const std::string start = scene.name(scene.objects[relay_object(out.u[way + RELAY_PRIM])]) + ">";
        if (name.substr(0, start.size()) != start) return false;
        name.remove_prefix(start.size());
    }
    return name == scene.name(scene.objects[source_objects[i]]);
}

uint32_t Flattener::relay_object(uint32_t prim) const {
    return std::find_if(relays.begin(), relays.end(), [&](const Relay& r) { return r.prim == prim; })->object;
}

// Of two sources of the same name, does i stand later in RADIANCE's list than j?  Real ones stand in the scene's order;
// virtual ones follow, the last real source's first, by its relays in the scene's order.
bool Flattener::source_is_later(const std::vector<float>& records, const std::vector<uint32_t>& source_objects,
                                uint32_t i, uint32_t j) const {
    const uint32_t a = bits(records[i * SOURCE_FLOATS + SRC_VIRTUAL]);
    const uint32_t b = bits(records[j * SOURCE_FLOATS + SRC_VIRTUAL]);
    if (a == NONE || b == NONE) return source_objects[i] > source_objects[j];
    const uint32_t before_a = out.u[a + RELAY_SOURCE], before_b = out.u[b + RELAY_SOURCE];
    if (before_a != before_b) {
        const bool real = bits(records[before_a * SOURCE_FLOATS + SRC_VIRTUAL]) == NONE;
        return source_is_later(records, source_objects, before_a, before_b) != real;
    }
    return relay_object(out.u[a + RELAY_PRIM]) > relay_object(out.u[b + RELAY_PRIM]);
}

// Sources that the same mists name are a set: a medium then is a few bits (kernels/medium.h).
void Flattener::link_mists(const std::vector<float>& records, const std::vector<uint32_t>& source_objects) {
    const uint32_t count = uint32_t(records.size() / SOURCE_FLOATS);
    std::vector<std::set<uint32_t>> named_by(count);  // mists, for each source
    for (const MistRef& m : mists) {
        const scene::Object& o = scene.objects[m.object];
        for (const std::string& name : scene.strings(o)) {
            uint32_t found = NONE;  // of several of that name one counts, the last in the list
            for (uint32_t i = 0; i < count; i++)
                if (source_is_called(records, source_objects, i, name) &&
                    (found == NONE || source_is_later(records, source_objects, i, found)))
                    found = i;
            if (found != NONE) named_by[found].insert(m.mod);
            else base::warn(scene.place(o), fmt::format("mist: \"{}\" is no light source, not scattered", name));
        }
    }
    std::map<std::set<uint32_t>, std::vector<uint32_t>> sets;
    for (uint32_t i = 0; i < count; i++)
        if (!named_by[i].empty()) sets[named_by[i]].push_back(i);
    if (sets.size() > 32)
        base::fail(scene.place(scene.objects[mists[0].object]),
                   "mists name more than 32 different sets of light sources");
    std::vector<uint32_t> directory;
    uint32_t bit = 1;
    for (const auto& [by, sources] : sets) {
        for (uint32_t mod : by) out.u[out.mods_at + MOD_WORDS * mod + MOD_EXTRA] |= bit;
        directory.push_back(uint32_t(out.u.size()));
        directory.push_back(uint32_t(sources.size()));
        out.u.insert(out.u.end(), sources.begin(), sources.end());
        bit <<= 1;
    }
    out.light_sets_at = uint32_t(out.u.size());
    out.u.insert(out.u.end(), directory.begin(), directory.end());
}

// What the eye sees of a distant surface: an illum's alternate, or the alternate's.
uint32_t Flattener::distant_seen(uint32_t mod) const {
    for (;;) {
        const uint32_t m = material_record(mod);
        if (m == NONE) return mod == NONE ? NONE : DISTANT_BLACK;
        const uint32_t type = mods[m * MOD_WORDS + MOD_TYPE];
        if (type != M_ILLUM) return material_has(type, MT_SHINES) != 0u ? mod : DISTANT_BLACK;
        mod = mods[m * MOD_WORDS + MOD_BRANCH1];
    }
}

// A source is chosen by what it gives in the mean.  Its pattern may hide more than these few looks find, so it keeps a
// hundredth of the bare material's power.
void Flattener::weigh_patterns(std::vector<float>& records) const {
    for (size_t at = 0; at < records.size(); at += SOURCE_FLOATS) {
        float* q = &records[at];
        const uint32_t* m = &mods[bits(q[SRC_MOD]) * MOD_WORDS];
        if (m[MOD_TYPE] >= M_FIRST_MATERIAL && m[MOD_NEXT] == NONE) continue;
        q[SRC_POWER] = std::max(float(mean_luminance(out, q)), .01f * q[SRC_POWER]);
    }
}

void Flattener::flatten_sources() {
    std::vector<float> records;
    std::vector<uint32_t> distant;
    std::vector<uint32_t> source_objects;  // scene object of each record
    std::vector<float> fans;               // 12 floats a triangle: v0, e1, e2, cumulative share end, begin, -
    std::vector<std::pair<size_t, size_t>> fan_patches;  // record offset, fan offset

    const auto start = [&](const scene::Object& material, uint32_t mod) {
        records.resize(records.size() + SOURCE_FLOATS, 0.0f);
        float* q = &records[records.size() - SOURCE_FLOATS];
        const auto c = scene.reals(material);
        q[SRC_PRIM] = from_bits(NONE);
        q[SRC_MOD] = from_bits(mod);
        q[SRC_POWER] = float(luminance_weight(c));
        q[SRC_SPOT + 3] = -2.0f;
        q[SRC_VIRTUAL] = from_bits(NONE);
        q[SRC_CLASS] = from_bits(scene::material_row(material.type).number);
        return q;
    };
    const auto black = [&](const scene::Span<double>& c) { return c[0] <= 0 && c[1] <= 0 && c[2] <= 0; };

    // local emitters
    for (const Emitter& e : emitters) {
        const scene::Object& o = scene.objects[e.object];
        const scene::Object& m = scene.objects[material_of[o.modifier]];
        const auto c = scene.reals(m);
        const auto r = scene.reals(o);
        if (black(c)) continue;
        if (m.type == Type::glow && c[3] <= 1e-6) continue;
        const std::string where = scene.place(o);
        if (o.type != Type::polygon && o.type != Type::sphere && o.type != Type::ring && o.type != Type::cylinder)
            base::fail(where, fmt::format("a {} cannot be a light source", type_name(o.type)));
        float* q = start(m, mod_of[o.modifier]);
        source_objects.push_back(e.object);
        q[SRC_PRIM] = from_bits(e.prim);
        if (m.type == Type::glow) q[SRC_MAXRAD] = float(c[3]);
        if (m.type == Type::spotlight) {
            const Vec3 aim = vec_at(c, 4);
            if (c[3] <= 0 || length(aim) <= 0) base::fail(scene.place(m), "spotlight with zero angle or direction");
            put(q + SRC_SPOT, unit(aim));
            q[SRC_SPOT + 3] = float(std::cos(std::min(c[3], 360.0) * PI / 360));
            q[SRC_SPOT + 4] = float(length(aim));
        }
        if (o.type == Type::sphere) {
            q[SRC_KIND] = from_bits(SK_SPHERE);
            put(q + SRC_CENTRE, vec_at(r, 0) - out.centre);
            q[SRC_RADIUS] = float(std::fabs(r[3]));
            q[SRC_AREA] = float(PI * r[3] * r[3]);  // as seen: the silhouette
        } else if (o.type == Type::ring) {
            if (std::min(r[6], r[7]) > 0) base::fail(where, "a light ring must have inner radius 0");
            const double radius = std::max(r[6], r[7]);
            const Vec3 n = unit(vec_at(r, 3)),
                       u = unit(std::fabs(n.z) < 0.9 ? cross(n, {0, 0, 1}) : cross(n, {1, 0, 0}));
            q[SRC_KIND] = from_bits(SK_RING);
            put(q + SRC_CENTRE, vec_at(r, 0) - out.centre);
            put(q + SRC_U, u * radius);
            put(q + SRC_V, cross(n, u) * radius);
            put(q + SRC_NORMAL, n);
            q[SRC_AREA] = float(PI * radius * radius);
            q[SRC_RADIUS] = float(radius);
        } else if (o.type == Type::cylinder) {
            const Vec3 a = vec_at(r, 0), b = vec_at(r, 3);
            q[SRC_KIND] = from_bits(SK_CYLINDER);
            put(q + SRC_CENTRE, (a + b) * 0.5 - out.centre);
            put(q + SRC_U, (b - a) * 0.5);
            q[SRC_AREA] = float(2 * PI * r[6] * length(b - a));
            q[SRC_RADIUS] = float(r[6]);
            if (r[6] > 0.2 * length(b - a)) base::warn(where, "cylindrical light source is not long and thin");
        } else {
            size_t n = r.size() / 3;
            std::vector<Vec3> v(n);
            for (size_t i = 0; i < n; i++) v[i] = vec_at(r, 3 * i);
            if (n > 3 && length(v[0] - v[n - 1]) <= 1e-6) v.resize(--n);
            Vec3 sum, mid;
            for (size_t i = 1; i + 1 < n; i++) sum = sum + cross(v[i] - v[0], v[i + 1] - v[0]);
            for (const Vec3& p : v) mid = mid + p * (1.0 / double(n));
            const Vec3 normal = unit(sum);
            put(q + SRC_CENTRE, mid - out.centre);
            put(q + SRC_NORMAL, normal);
            q[SRC_AREA] = float(length(sum) / 2);
            double radius = 0;
            for (const Vec3& p : v) radius = std::max(radius, length(p - mid));
            q[SRC_RADIUS] = float(radius);
            const bool parallelogram = n == 4 && length(v[0] + v[2] - v[1] - v[3]) <= 1e-4 * radius;
            if (parallelogram) {
                q[SRC_KIND] = from_bits(SK_PARALLELOGRAM);
                put(q + SRC_U, (v[1] - v[0]) * 0.5);
                put(q + SRC_V, (v[3] - v[0]) * 0.5);
            } else {
                q[SRC_KIND] = from_bits(SK_POLYGON);
                Vec3 u, w;  // RADIANCE's size vectors, for -ds with -dj below 1 (spec shading 4.3)
                size_vectors(v, mid, normal, length(sum) / 2, u, w);
                put(q + SRC_U, u);
                put(q + SRC_V, w);
                const auto tris = triangulate(v, normal);
                double total = 0, done = 0;
                std::vector<double> area;
                for (const auto& t : tris) {
                    area.push_back(length(cross(v[t[1]] - v[t[0]], v[t[2]] - v[t[0]])) / 2);
                    total += area.back();
                }
                fan_patches.push_back({records.size() - SOURCE_FLOATS, fans.size()});
                q[SRC_NTRIS] = from_bits(uint32_t(tris.size()));
                q[SRC_AREA] = float(total);
                for (size_t i = 0; i < tris.size(); i++) {
                    float rec[12] = {};
                    const Vec3 a = v[tris[i][0]] - out.centre;
                    put(rec, a);
                    put(rec + 3, v[tris[i][1]] - out.centre - a);
                    put(rec + 6, v[tris[i][2]] - out.centre - a);
                    rec[10] = float(done / total);
                    done += area[i];
                    rec[9] = float(done / total);
                    fans.insert(fans.end(), rec, rec + 12);
                }
            }
        }
        out.prims[PRIM_WORDS * e.prim + PRIM_SOURCE] = uint32_t(records.size() / SOURCE_FLOATS - 1);
    }

    // distant ones
    for (const scene::Object& o : scene.objects) {
        if (o.type != Type::source || o.modifier < 0 || !has_material[o.modifier]) continue;
        const uint32_t mo = material_of[o.modifier];
        if (mo == NONE) base::fail(scene.place(o), "a distant source needs a light or glow");
        const scene::Object& m = scene.objects[mo];
        const auto r = scene.reals(o);
        const auto c = scene.reals(m);
        const Vec3 d = unit(vec_at(r, 0));
        const double half = std::min(r[3], 360.0) * PI / 360, s = std::sin(half / 2), cap = r[3] >= 360 ? 3 : 2 * s * s;
        uint32_t rec[DISTANT_WORDS] = {bits(float(d.x)),
                                       bits(float(d.y)),
                                       bits(float(d.z)),
                                       bits(float(cap)),
                                       distant_seen(mod_of[o.modifier]),
                                       NONE,
                                       0,
                                       0};
        if (!scene::shines(m.type))
            base::fail(scene.place(o),
                       fmt::format("a distant source of material {} is not supported", type_name(m.type)));
        if (m.type != Type::glow && !black(c)) {
            float* q = start(m, mod_of[o.modifier]);
            source_objects.push_back(uint32_t(&o - scene.objects.data()));
            q[SRC_KIND] = from_bits(SK_DISTANT);
            put(q + SRC_CENTRE, d);
            q[SRC_CAP] = float(std::min(cap, 2.0));
            q[SRC_AREA] = float(2 * PI * std::min(cap, 2.0));
            q[SRC_RADIUS] = float(std::sin(half));
            rec[DISTANT_SOURCE] = uint32_t(records.size() / SOURCE_FLOATS - 1);
        }
        distant.insert(distant.end(), rec, rec + DISTANT_WORDS);
    }

    weigh_patterns(records);
    if (options.dr > 0 && !relays.empty() && !records.empty()) add_virtual_sources(records, fans, fan_patches);
    link_mists(records, source_objects);
    if (aimed) out.shadow_mode = SHADOW_AIMED;
    out.source_count = uint32_t(records.size() / SOURCE_FLOATS);
    out.distant_count = uint32_t(distant.size() / DISTANT_WORDS);
    out.distant_at = uint32_t(out.u.size());
    out.u.insert(out.u.end(), distant.begin(), distant.end());
    const uint32_t fans_at = uint32_t(out.f.size());
    out.f.insert(out.f.end(), fans.begin(), fans.end());
    for (const auto& p : fan_patches) records[p.first + SRC_TRIS] = from_bits(uint32_t(fans_at + p.second));
    out.sources_at = uint32_t(out.f.size());
    out.f.insert(out.f.end(), records.begin(), records.end());
    out.cdf_at = uint32_t(out.f.size());
    double total = 0, sum = 0;
    const auto power = [&](uint32_t i) {  // never 0, so that the table can reach every source
        const float* q = &records[i * SOURCE_FLOATS];
        return double(std::max(q[SRC_POWER], 1e-20f)) * std::max(q[SRC_AREA], 1e-20f);
    };
    for (uint32_t i = 0; i < out.source_count; i++) total += power(i);
    for (uint32_t i = 0; i < out.source_count; i++) {
        sum += power(i);
        out.f.push_back(float(sum / total));
    }
}

}  // namespace trace
