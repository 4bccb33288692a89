// SPDX-License-Identifier: BSD-3-Clause
// The sources that mists name, whose light they scatter.  A virtual source is named by the path back from the point
// lit: "relay>relay>source".
#include <algorithm>
#include <fmt/core.h>
#include <map>
#include <set>
#include <string_view>

#include "base/error.h"
#include "flatten/sources.h"

namespace flatten {
namespace {

constexpr size_t MOST_SETS = 32;  // bits of Modifier.lights

class Names {
public:
    Names(const scene::Scene& scene, const std::vector<Lights::Relay>& relays, const Sources& sources,
          const FlatScene& out)
        : scene_(scene), relays_(relays), sources_(sources), out_(out) {}

    // The last source of this name in RADIANCE's list; NONE if there is none.
    uint32_t find(std::string_view name) const {
        uint32_t found = NONE;
        for (uint32_t i = 0; i < sources_.count(); i++)
            if (is_called(i, name) && (found == NONE || is_later(i, found))) found = i;
        return found;
    }

private:
    uint32_t way(uint32_t source) const { return sources_.records[source].relay; }

    uint32_t relay_object(uint32_t way) const {
        const uint32_t prim = out_.relays[way].prim;
        return std::find_if(relays_.begin(), relays_.end(), [&](const auto& r) { return r.prim == prim; })->object;
    }

    bool is_called(uint32_t i, std::string_view name) const {
        for (; way(i) != NONE; i = out_.relays[way(i)].source) {
            const std::string start = scene_.name(scene_.objects[relay_object(way(i))]) + ">";
            if (name.substr(0, start.size()) != start) return false;
            name.remove_prefix(start.size());
        }
        return name == scene_.name(scene_.objects[sources_.objects[i]]);
    }

    // Returns true if source i comes after j, of the same name, in RADIANCE's list.  Real ones are in the scene's
    // order; virtual ones follow, the last real source's first, by its relays in the scene's order.
    bool is_later(uint32_t i, uint32_t j) const {
        const uint32_t a = way(i), b = way(j);
        if (a == NONE || b == NONE) return sources_.objects[i] > sources_.objects[j];
        const uint32_t before_a = out_.relays[a].source, before_b = out_.relays[b].source;
        if (before_a != before_b) return is_later(before_a, before_b) != (way(before_a) == NONE);
        return relay_object(a) > relay_object(b);
    }

    const scene::Scene& scene_;
    const std::vector<Lights::Relay>& relays_;
    const Sources& sources_;
    const FlatScene& out_;
};

}  // namespace

// Sources that the same mists name form a set, so that a medium stores a few bits (kernels/material/medium.h).
void link_mists(const Modifiers& modifiers, const std::vector<Lights::Relay>& relays, const Sources& sources,
                FlatScene& out) {
    const scene::Scene& scene = modifiers.scene;
    const Names names(scene, relays, sources, out);
    std::vector<std::set<uint32_t>> named_by(sources.count());  // mists, for each source
    for (const Modifiers::Mist& mist : modifiers.mists) {
        const scene::Object& o = scene.objects[mist.object];
        for (const std::string& name : scene.strings(o)) {
            const uint32_t found = names.find(name);
            if (found != NONE) named_by[found].insert(mist.record);
            else
                base::warn(scene.place(o),
                           fmt::format("mist: \"{}\" is not a light source and is not scattered", name));
        }
    }

    std::map<std::set<uint32_t>, std::vector<uint32_t>> sets;
    for (uint32_t i = 0; i < named_by.size(); i++)
        if (!named_by[i].empty()) sets[named_by[i]].push_back(i);
    if (sets.size() > MOST_SETS)
        base::fail(scene.place(scene.objects[modifiers.mists[0].object]),
                   "mists name more than 32 different sets of light sources");

    uint32_t bit = 1;
    for (const auto& [by, members] : sets) {
        for (uint32_t mod : by) out.modifiers[mod].lights |= bit;
        out.light_sets.push_back({uint32_t(out.u.size()), uint32_t(members.size())});
        out.u.insert(out.u.end(), members.begin(), members.end());
        bit <<= 1;
    }
}

}  // namespace flatten
