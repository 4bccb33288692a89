// SPDX-License-Identifier: BSD-3-Clause
// See seen.h.
#include "render/seen.h"

#include <fmt/core.h>

#include <cmath>
#include <vector>

#include "base/angle.h"
#include "flatten/host_tracer.h"
#include "render/pixel_names.h"

namespace render {
namespace {

constexpr size_t most_seen = 5, most_reals = 12;

std::string named(const scene::Scene& scene, const scene::Object* o) {
    return o ? scene.name(*o) + "\t" + scene::type_name(o->type) + "\t" + scene.place(*o) : "\t\t";
}

std::string line_of(const scene::Scene& scene, const scene::Object& o, base::Vec3 at) {
    const int32_t material = scene.material(o.modifier).object;
    std::string text = named(scene, &o) + "\t" +
                       named(scene, material == scene::VOID ? nullptr : &scene.objects[size_t(material)]) +
                       fmt::format("\t{:.6g} {:.6g} {:.6g}\t", at.x, at.y, at.z);
    const scene::Span<double> reals = scene.reals(o);
    if (reals.size() <= most_reals)
        for (size_t k = 0; k < reals.size(); ++k) text += fmt::format(k ? " {:.8g}" : "{:.8g}", reals[k]);
    return text;
}

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
    const flatten::FlatScene& tables = *loaded.tables;
    const flatten::HostTracer tracer(tables);
    const Names names(tables, scene);
    std::vector<std::string> lines;
    const double end = ray->tmax > 0 ? ray->tmax : 1e30;
    bool closed = false;
    for (double from = 0; !closed;) {
        const auto hit = tracer.closest(ray->origin, ray->dir, from, end, flatten::HostTracer::all);
        if (hit.t < 0) break;
        closed = !flatten::see_through(tables, hit.prim, hit.inst);
        if (const scene::Object* o = names.surface(hit.prim, hit.inst))
            lines.push_back(line_of(scene, *o, ray->origin + ray->dir * hit.t));
        if (lines.size() > most_seen) lines.erase(lines.end() - 2);
        from = hit.t * (1 + 1e-6) + 1e-7;
    }
    if (const scene::Object* o = closed || end < 1e30 ? nullptr : distant_in(scene, ray->dir))
        lines.push_back(line_of(scene, *o, ray->dir));
    std::string text;
    for (const std::string& line : lines) text += (text.empty() ? "" : "\t") + line;
    return text;
}

}  // namespace render
