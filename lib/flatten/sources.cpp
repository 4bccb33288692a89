// SPDX-License-Identifier: BSD-3-Clause
// Chooses the active sources among the emitters (spec shading 4.1) and writes their records; distant surfaces in order.
// Sampled rays alone find all other emitters.
#include "flatten/sources.h"

#include <algorithm>
#include <cmath>
#include <fmt/core.h>

#include "base/angle.h"
#include "base/error.h"
#include "flatten/evaluate.h"
#include "scene/materials.h"

namespace flatten {
namespace {
using base::pi;

double luminance_weight(const Reals& c) { return .265074126 * c[0] + .670114631 * c[1] + .064811243 * c[2]; }
// RADIANCE leaves out distant sources of this radiance: what is behind them, or nothing, is seen in their place.
bool is_nothing(const Reals& c) {
    constexpr double FTINY = 1e-6;
    return c[0] <= FTINY && c[1] <= FTINY && c[2] <= FTINY;
}
bool black(const Reals& c) { return c[0] <= 0 && c[1] <= 0 && c[2] <= 0; }

void aim_spotlight(const Reals& c, const std::string& place, Source& q) {
    const Vec3 aim = vec_at(c, 4);
    if (c[3] <= 0 || length(aim) <= 0) base::fail(place, "spotlight with zero angle or direction");
    q.spot = packed(unit(aim));
    q.spot_cos = float(std::cos(std::min(c[3], 360.0) * pi / 360));
    q.spot_focus = float(length(aim));
}

// Visible modifier of a distant surface: of an illum its alternate, or that one's.
uint32_t distant_seen(const FlatScene& out, uint32_t mod) {
    for (;;) {
        const uint32_t m = material_record(out, mod);
        if (m == NONE) return mod == NONE ? NONE : DISTANT_BLACK;
        const uint32_t type = out.modifiers[m].type;
        if (type != M_ILLUM) return material_has(type, MT_EMISSIVE) != 0u ? mod : DISTANT_BLACK;
        mod = out.modifiers[m].branch1;
    }
}

// The material of a distant surface, which must be a light.
const Object& distant_material(const Modifiers& modifiers, const Object& o) {
    const scene::Scene& scene = modifiers.scene;
    const uint32_t m = modifiers.material[o.modifier];
    if (m == NONE) base::fail(scene.place(o), "a distant source needs a light or glow");
    const Object& material = scene.objects[m];
    if (!scene::is_emissive(material.type))
        base::fail(scene.place(o),
                   fmt::format("a distant source of material {} is not supported", type_name(material.type)));
    return material;
}

}  // namespace

Source& add_source(const Modifiers& modifiers, const Object& surface, Sources& sources) {
    const scene::Scene& scene = modifiers.scene;
    const Object& material = scene.objects[modifiers.material[surface.modifier]];
    const Reals c = scene.reals(material);
    sources.objects.push_back(uint32_t(&surface - scene.objects.data()));
    Source& q = sources.records.emplace_back();
    q.prim = NONE;
    q.mod = modifiers.record[surface.modifier];
    q.power = float(luminance_weight(c));
    q.spot_cos = NO_SPOT;
    q.relay = NONE;
    q.light_type = scene::material_row(material.type).number;
    return q;
}

void add_local_sources(const Modifiers& modifiers, const std::vector<Lights::Emitter>& emitters, FlatScene& out,
                       Sources& sources) {
    const scene::Scene& scene = modifiers.scene;
    for (const Lights::Emitter& e : emitters) {
        const Object& o = scene.objects[e.object];
        if (o.type == Type::instance || o.type == Type::mesh) continue;  // they are visible but light nothing
        const Object& material = scene.objects[modifiers.material[o.modifier]];
        const Reals c = scene.reals(material);
        if (black(c)) continue;
        if (material.type == Type::glow && c[3] <= 1e-6) continue;
        Source& q = add_source(modifiers, o, sources);
        q.prim = e.prim;
        if (material.type == Type::glow) q.max_radius = float(c[3]);
        if (material.type == Type::spotlight) aim_spotlight(c, scene.place(material), q);
        shape_source(scene, o, out.centre, sources.fans, q);
        out.prims[e.prim].source = sources.count() - 1;
    }
}

void add_distant_sources(const Modifiers& modifiers, FlatScene& out, Sources& sources) {
    const scene::Scene& scene = modifiers.scene;
    for (const Object& o : scene.objects) {
        if (o.type != Type::source || o.modifier < 0 || !modifiers.has_material[o.modifier]) continue;
        const Object& material = distant_material(modifiers, o);
        if (is_nothing(scene.reals(material))) continue;
        const Reals r = scene.reals(o);
        const Vec3 d = unit(vec_at(r, 0));
        const double half = std::min(r[3], 360.0) * pi / 360, s = std::sin(half / 2), cap = r[3] >= 360 ? 3 : 2 * s * s;
        const uint32_t seen = distant_seen(out, modifiers.record[o.modifier]);
        if (seen < DISTANT_BLACK && (out.modifiers[seen].flags & MF_PLACE) != 0) out.sky_places = true;
        Distant distant{packed(d), float(cap), seen, NONE};
        if (material.type != Type::glow) {
            Source& q = add_source(modifiers, o, sources);
            q.kind = SK_DISTANT;
            q.centre = packed(d);
            q.cap = float(std::min(cap, 2.0));
            q.area = float(2 * pi * std::min(cap, 2.0));
            q.radius = float(std::sin(half));
            distant.source = sources.count() - 1;
        }
        sources.distant.push_back(distant);
        sources.distant_objects.push_back(uint32_t(&o - scene.objects.data()));
    }
}

// Sources are chosen by their mean power.  A pattern may hide more than these few samples show, so a source keeps at
// least a hundredth of the bare material's power.
void weigh_patterns(const FlatScene& out, Sources& sources, size_t first) {
    for (size_t i = first; i < sources.records.size(); i++) {
        Source& q = sources.records[i];
        const Modifier& m = out.modifiers[q.mod];
        if (m.type >= M_FIRST_MATERIAL && m.next == NONE) continue;
        q.power = std::max(float(mean_luminance(out, q)), .01f * q.power);
    }
}

void write_sources(Sources sources, FlatScene& out) {
    out.sources = std::move(sources.records);
    out.fans = std::move(sources.fans);
    out.distant = std::move(sources.distant);
    out.source_object = std::move(sources.objects);
    out.distant_object = std::move(sources.distant_objects);
}

Sources take_sources(FlatScene& out) {
    return {std::move(out.sources), std::move(out.source_object), std::move(out.fans), std::move(out.distant),
            std::move(out.distant_object)};
}

}  // namespace flatten
