// SPDX-License-Identifier: BSD-3-Clause
// See seen.h.
#include "visibility/seen.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace visibility {

namespace {

constexpr double large = .25, small = .05;  // shares
constexpr size_t most_named = 3;

// What rays end at, and what they have passed.
struct Seen {
    double weight = 0;
    std::map<std::string, double> through;
    std::set<unsigned> surfaces;
};

std::string modifier_of(const region::SceneView& scene, unsigned surface) {
    const std::vector<std::string> names = scene.modifier_names(surface);
    return names.empty() ? "void" : names[0];
}
std::string name_of(const region::SceneView& scene, unsigned surface) {
    return scene.surface_name(surface) + " (" + modifier_of(scene, surface) + ")";
}

// Items with a weight from the heaviest on, as far as each has this share.
template <class ITEMS, class WEIGHT>
auto heaviest(const ITEMS& items, double sum, double share, WEIGHT&& weight) {
    std::vector<const typename ITEMS::value_type*> out;
    for (const auto& item : items)
        if (weight(item) >= share * sum) out.push_back(&item);
    std::stable_sort(out.begin(), out.end(), [&](auto* a, auto* b) { return weight(*a) > weight(*b); });
    if (out.size() > most_named) out.resize(most_named);
    return out;
}

std::map<std::string, Seen> collect(const region::SceneView& scene, const std::vector<WeightedRay>& rays,
                                    bool by_object) {
    std::map<std::string, Seen> all;
    for (const WeightedRay& ray : rays) {
        region::Crossing crossings[24];
        bool closed = false;
        const int n = scene.look(ray.origin, ray.dir, ray.tmax, crossings, 24, closed);
        const bool far = n > 0 && crossings[n - 1].t >= 1e30, ends = closed || far;
        const unsigned last = ends ? crossings[n - 1].surface : 0;
        Seen& seen = all[!ends ? "nothing of the scene" : by_object ? name_of(scene, last) : modifier_of(scene, last)];
        seen.weight += ray.weight;
        seen.surfaces.insert(last);
        const bool passes = n > (ends ? 1 : 0) && crossings[0].t < 1e30;
        if (passes) seen.through[name_of(scene, crossings[0].surface)] += ray.weight;
    }
    return all;
}

}  // namespace

std::string seen_along(const region::SceneView& scene, const std::vector<WeightedRay>& rays) {
    double sum = 0;
    for (const WeightedRay& ray : rays) sum += ray.weight;
    const auto weight = [](const auto& item) { return item.second.weight; };
    std::map<std::string, Seen> all = collect(scene, rays, true);
    const bool by_object = !heaviest(all, sum, large, weight).empty();
    if (!by_object) all = collect(scene, rays, false);  // slats of a blind
    std::string out;
    for (const auto* item : heaviest(all, sum, small, weight)) {
        const Seen& seen = item->second;
        out += (out.empty() ? "" : "; ") + item->first;
        if (!by_object && seen.surfaces.size() > 1) out += fmt::format(" ({} objects)", seen.surfaces.size());
        std::string passed;
        for (const auto* pane : heaviest(seen.through, seen.weight, small, [](const auto& p) { return p.second; }))
            passed += (passed.empty() ? " through " : ", ") + pane->first;
        out += passed;
        if (seen.weight < (1 - small) * sum) out += fmt::format(", {:.0f} %", 100 * seen.weight / sum);
    }
    return out;
}

}  // namespace visibility
