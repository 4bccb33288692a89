// SPDX-License-Identifier: BSD-3-Clause
// See named_modifiers.h.
#include "flatten/named_modifiers.h"

namespace flatten {
using scene::Object;
using scene::Type;

bool has_alternate(const scene::Scene& scene, const Object& o) {
    return (o.type == Type::mirror || o.type == Type::illum) && scene.strings(o).size() > 0;
}

std::vector<int32_t> named_modifiers(const scene::Scene& scene, uint32_t object) {
    const Object& o = scene.objects[object];
    const auto s = scene.strings(o);
    std::vector<int32_t> out;
    const auto add = [&](size_t k) { out.push_back(scene.lookup_modifier(s[k], int32_t(object))); };
    if (has_alternate(scene, o)) add(0);
    if (o.type == Type::antimatter)
        for (size_t k = 0; k < s.size(); k++) add(k);
    if (o.type == Type::WGMDfunc)
        for (int k : wgmd_names)
            if (s[size_t(k)] != "inherit") add(size_t(k));
    if (is_mixture(o.type)) {
        add(0);
        add(1);
    }
    return out;
}

std::vector<uint8_t> needed_modifiers(const scene::Scene& scene, size_t begin, size_t end,
                                      const std::vector<int32_t>& also_used) {
    std::vector<uint8_t> needed(end, 0);
    const auto need = [&](int32_t i) {
        if (i >= 0) needed[i] = 1;
    };
    for (int32_t m : also_used) need(m);
    for (size_t i = end; i-- > 0;) {
        if (scene::is_surface(scene.objects[i].type)) {
            if (i >= begin) need(scene.objects[i].modifier);
        } else if (needed[i]) {
            const auto r = scene.resolve(int32_t(i));
            need(r.modifier);
            for (int32_t m : named_modifiers(scene, uint32_t(r.object))) need(m);
        }
    }
    return needed;
}

}  // namespace flatten
