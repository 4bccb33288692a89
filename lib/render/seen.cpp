// SPDX-License-Identifier: BSD-3-Clause
// See seen.h.
#include "render/seen.h"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "base/angle.h"
#include "flatten/host_tracer.h"
#include "kernels/dialect/host.h"
#include "render/pane.h"
#include "render/pixel_names.h"

namespace render {
namespace {

using namespace kernels;

constexpr size_t most_seen = 5, most_reals = 12;

std::string text_of(const Names::Name& n) { return n.name + "\t" + n.type + "\t" + n.place + "\t"; }

std::string line_of(const Names::Name& surface, const Names::Name& material, base::Vec3 at,
                    const std::vector<double>& reals) {
    std::string text = text_of(surface) + text_of(material) + fmt::format("{:.6g} {:.6g} {:.6g}\t", at.x, at.y, at.z);
    if (reals.size() <= most_reals)
        for (size_t k = 0; k < reals.size(); ++k) text += fmt::format(k ? " {:.8g}" : "{:.8g}", reals[k]);
    return text;
}

// The surfaces that a ray from the eye meets, one after another.
class Gaze {
public:
    using Found = flatten::HostTracer::Found;
    Gaze(const flatten::FlatScene& tables, const scene::Scene& scene, const view::Projector::Ray& ray)
        : tables_(tables), scene_(scene), names_(tables, scene), tracer_(tables), ray_(ray) {}

    std::optional<Found> next(double end) {
        const Found hit = tracer_.closest(ray_.origin, ray_.dir, from_, end, flatten::HostTracer::all);
        if (hit.t < 0) return {};
        from_ = hit.t * (1 + 1e-6) + 1e-7;
        return hit;
    }
    bool is_clear(const Found& hit) const { return flatten::see_through(tables_, hit.prim, hit.inst); }

    // The pane behind the slats of a blind, which are of one material.
    std::optional<Found> behind(const Found& slat) {
        const uint32_t material = flatten::material_of(tables_, slat.prim, slat.inst);
        for (int passed = 0; passed < most_slats; ++passed) {
            const std::optional<Found> hit = next(2 * slat.t);
            if (!hit || is_clear(*hit)) return hit;
            if (flatten::material_of(tables_, hit->prim, hit->inst) != material) break;
        }
        return {};
    }

    std::string line(const Found& hit) const {
        return line_of(names_.surface(hit.prim, hit.inst), names_.material(hit.prim, hit.inst),
                       ray_.origin + ray_.dir * hit.t, reals(hit));
    }

private:
    std::vector<double> reals(const Found& hit) const {
        const bool inside = hit.inst != flatten::FlatScene::NO_OBJECT;
        const scene::Object* o = names_.object(hit.prim, hit.inst);
        std::vector<double> own;
        if (o && !inside) {
            const scene::Span<double> all = scene_.reals(*o);
            own.assign(all.begin(), all.end());
        }
        const uint32_t kind = tables_.prims[hit.prim].kind & PRIM_KIND_MASK;
        const bool flat = kind == PRIM_FLAT || kind == PRIM_SMOOTH, ring = o && o->type == scene::Type::ring;
        if (!flat || ring || !is_clear(hit) || own.size() == 12) return own;
        std::vector<double> corners;
        for (const base::Vec3& c : rectangle_around(tables_, tracer_, hit, hit.t / 300))
            corners.insert(corners.end(), {c.x, c.y, c.z});
        return corners;
    }

    static constexpr int most_slats = 50;
    const flatten::FlatScene& tables_;
    const scene::Scene& scene_;
    const Names names_;
    const flatten::HostTracer tracer_;
    const view::Projector::Ray ray_;
    double from_ = 0;
};

// Of the distant surfaces in this direction the smallest one.
const scene::Object* distant_in(const scene::Scene& scene, base::Vec3 dir) {
    const scene::Object* found = nullptr;
    double smallest = 1e9;
    for (const scene::Object& o : scene.objects) {
        if (o.type != scene::Type::source) continue;
        const scene::Span<double> r = scene.reals(o);
        const base::Vec3 axis = base::unit({r[0], r[1], r[2]});
        const double off = std::atan2(base::length(base::cross(axis, dir)), base::dot(axis, dir)) / base::degree;
        if (off <= r[3] / 2 && r[3] <= smallest) found = &o, smallest = r[3];
    }
    return found;
}

}  // namespace

std::string seen_at(const LoadedScene& loaded, const scene::Scene& scene, const view::View& view, double x, double y) {
    const auto ray = view::Projector(view).ray(x, y);
    if (!ray) return "";
    const Names names(*loaded.tables, scene);
    Gaze gaze(*loaded.tables, scene, *ray);
    std::vector<std::string> lines;
    const double end = ray->tmax > 0 ? ray->tmax : 1e30;
    bool closed = false;
    while (const auto hit = gaze.next(end)) {
        lines.push_back(gaze.line(*hit));
        if (lines.size() > most_seen) lines.erase(lines.end() - 2);
        closed = !gaze.is_clear(*hit);
        if (!closed) continue;
        if (const auto pane = gaze.behind(*hit)) lines.push_back(gaze.line(*pane));
        break;
    }
    if (const scene::Object* o = closed || end < 1e30 ? nullptr : distant_in(scene, ray->dir)) {
        const int32_t material = scene.material(o->modifier).object;
        const scene::Span<double> all = scene.reals(*o);
        lines.push_back(line_of(names.name(o),
                                names.name(material == scene::VOID ? nullptr : &scene.objects[size_t(material)]),
                                ray->dir, {all.begin(), all.end()}));
    }
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\t") + line;
    return text;
}

}  // namespace render
