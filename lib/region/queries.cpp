// SPDX-License-Identifier: BSD-3-Clause
// See queries.h.
#include "region/queries.h"
#include <algorithm>
#include <fmt/format.h>
#include "base/error.h"

namespace region {
namespace {

// The names that a query of this kind compares: the surface's own, or its modifiers'.
std::vector<std::string> names_of(Kind kind, const SceneView& scene, unsigned surface) {
    if (kind == Kind::modifier) return scene.modifier_names(surface);
    const std::string name = scene.surface_name(surface);
    return name.empty() ? std::vector<std::string>{} : std::vector<std::string>{name};
}

std::vector<std::string> all_names(Kind kind, const SceneView& scene) {
    std::vector<std::string> all;
    for (unsigned k = 0; k < scene.surfaces(); ++k)
        for (std::string& name : names_of(kind, scene, k)) all.push_back(std::move(name));
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

[[noreturn]] void fail_unknown(const Shape& shape, const SceneView& scene) {
    const bool modifier = shape.kind == Kind::modifier;
    const std::vector<std::string> others = all_names(modifier ? Kind::surface : Kind::modifier, scene);
    std::string hint = near_matches(shape.text, all_names(shape.kind, scene));
    const char* other = modifier ? "surface" : "modifier";
    if (std::any_of(others.begin(), others.end(), [&](const auto& name) { return matches(shape.text, name); }))
        hint = fmt::format("; it is a {}'s name: \"{} {}\"", other, other, shape.text);
    else if (const std::string near = near_matches(shape.text, others); hint.empty() && !near.empty())
        hint = fmt::format("; of the {}s{}", other, near);
    base::fail(shape.place, fmt::format("no {} of the scene is called \"{}\"{}",
                                        modifier ? "surface's modifier" : "surface", shape.text, hint));
}

}  // namespace

std::vector<std::vector<char>> meant_surfaces(const Regions& regions, const SceneView& scene) {
    std::vector<std::vector<char>> meant(regions.shapes.size());
    for (const Kind kind : {Kind::surface, Kind::modifier})
        for (size_t s = 0; s < regions.shapes.size(); ++s) {
            const Shape& shape = regions.shapes[s];
            if (shape.kind != kind) continue;
            meant[s].assign(scene.surfaces(), 0);
            bool any = false;
            for (unsigned k = 0; k < scene.surfaces(); ++k) {
                for (const std::string& name : names_of(kind, scene, k))
                    if (matches(shape.text, name)) meant[s][k] = 1;
                any = any || meant[s][k];
            }
            if (!any) fail_unknown(shape, scene);
        }
    return meant;
}

}  // namespace region
