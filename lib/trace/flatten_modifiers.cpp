// SPDX-License-Identifier: BSD-3-Clause
// Modifier chains -> MOD records.  Only what some surface uses is compiled; modifiers always stand before their users,
// so one pass down marks what is needed and one pass up builds it, without recursion (chains may be 10,000 deep).
#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "scene/materials.h"
#include "trace/flatten.h"

namespace trace {
namespace {
using namespace kernels;
using scene::Type;

constexpr int wgmd_names[3] = {0, 4, 8};        // strings of WGMDfunc that name modifiers
constexpr uint32_t WGMD_INHERIT = 0xfffffffeu;  // as kernels/mat_wgmd.h

uint32_t mod_type(cal::ProgramKind k) {
    switch (k) {
    case cal::ProgramKind::brightness: return M_PATTERN1;
    case cal::ProgramKind::color: return M_PATTERN3;
    case cal::ProgramKind::texture: return M_TEXTURE;
    default: return M_MIXTURE;
    }
}
cal::PatternSpec spec_of(const scene::Scene& scene, const scene::Object& o) {
    const auto s = scene.strings(o);
    const auto r = scene.reals(o);
    return {type_name(o.type), {s.begin(), s.end()}, {r.begin(), r.end()}, scene.place(o), {}};
}
}  // namespace

uint32_t Flattener::material_record(uint32_t mod) const {
    while (mod != NONE && mods[mod * MOD_WORDS + MOD_TYPE] < M_FIRST_MATERIAL) mod = mods[mod * MOD_WORDS + MOD_NEXT];
    return mod;
}

void Flattener::flatten_modifiers() {
    const size_t n = scene.objects.size();
    mod_of.assign(n, NONE);
    has_material.assign(n, 0);
    passes.assign(n, 0);
    material_of.assign(n, NONE);
    std::vector<uint8_t> needed(n, 0);
    std::vector<int> nesting(n, 0);  // of mixtures of patterns, from here on
    const auto need = [&](int32_t i) {
        if (i >= 0) needed[i] = 1;
    };
    for (int32_t m : also_used) need(m);
    // Names among the string arguments that are modifiers, for what is not found by the chain.
    const auto branches = [&](const scene::Object& o, uint32_t at) {
        const auto s = scene.strings(o);
        return std::pair<int32_t, int32_t>{scene.lookup_modifier(s[0], at), scene.lookup_modifier(s[1], at)};
    };
    const auto alternate = [&](const scene::Object& o, uint32_t at) {
        const auto s = scene.strings(o);
        return (o.type == Type::mirror || o.type == Type::illum) && s.size() > 0 ? scene.lookup_modifier(s[0], at)
                                                                                 : scene::VOID;
    };
    for (size_t i = n; i-- > 0;) {
        const scene::Object& o = scene.objects[i];
        if (scene::is_surface(o.type)) {
            need(o.modifier);
            continue;
        }
        if (!needed[i]) continue;
        const auto r = scene.resolve(int32_t(i));
        need(r.modifier);
        const scene::Object& t = scene.objects[r.object];
        need(alternate(t, uint32_t(r.object)));
        if (t.type == Type::antimatter)
            for (const std::string& name : scene.strings(t)) need(scene.lookup_modifier(name, uint32_t(r.object)));
        if (t.type == Type::WGMDfunc)
            for (int k : wgmd_names)
                if (scene.strings(t)[size_t(k)] != "inherit")
                    need(scene.lookup_modifier(scene.strings(t)[size_t(k)], uint32_t(r.object)));
        if (is_mixture(t.type)) {
            const auto b = branches(t, uint32_t(r.object));
            need(b.first);
            need(b.second);
        }
    }
    uint32_t antimatters = 0;
    for (size_t i = 0; i < n; i++) {
        if (!needed[i]) continue;
        const auto r = scene.resolve(int32_t(i));
        const scene::Object& t = scene.objects[r.object];
        const auto reals = scene.reals(t);
        uint32_t rec[MOD_WORDS] = {0, NONE, NONE, 0, NONE, NONE, 0, 0};
        if (r.modifier >= 0) {
            rec[MOD_NEXT] = mod_of[r.modifier];
            nesting[i] = nesting[r.modifier];
        }
        rec[MOD_ARGS] = uint32_t(args.size());
        const bool above = r.modifier >= 0 && has_material[r.modifier];
        if (scene::is_material(t.type)) {
            if (above)
                base::fail(scene.place(scene.objects[i]),
                           fmt::format("material \"{}\" has another material above it", scene.name(scene.objects[i])));
            const scene::Material& row = scene::material_row(t.type);
            rec[MOD_TYPE] = row.number;
            rec[MOD_FLAGS] = row.flags;
            for (double a : reals) args.push_back(float(a));
            if (reals.size() < row.filled) args.resize(rec[MOD_ARGS] + row.filled, row.fill);
            if (t.type == Type::mirror || t.type == Type::illum) {
                const int32_t m = alternate(t, uint32_t(r.object));
                if (m >= 0) rec[MOD_BRANCH1] = mod_of[m];
                if (scene.strings(t).size() > 0) rec[MOD_FLAGS] |= MF_HAS_ALTERNATE;
                const bool mixed = m >= 0 && has_material[m] && material_of[m] == NONE;
                if (m < 0 || !has_material[m] || (!mixed && mirror_gives_way(scene, scene.objects[material_of[m]])))
                    rec[MOD_FLAGS] |= MF_ALTERNATE_PASSES;
            }
            if ((row.traits & MT_MEDIUM) != 0) out.absorbs = true;
            if ((row.traits & MT_BENDS) != 0) aimed = true;
            if (cal::has_functions(type_name(t.type))) {
                const cal::MaterialProgram p = cal::compile_material(library, spec_of(scene, t), code);
                rec[MOD_PROGRAM] = p.values;
                if (p.value_count > 0) rec[MOD_FLAGS] |= MF_VALUES;
                if (t.type == Type::WGMDfunc) {  // modifiers of rs, ts, td: indices for mat_wgmd, in the word arena
                    rec[MOD_BRANCH1] = uint32_t(code.words.size());
                    for (int k : wgmd_names) {
                        const std::string& name = scene.strings(t)[size_t(k)];
                        const int32_t m =
                            name == "inherit" ? scene::VOID : scene.lookup_modifier(name, uint32_t(r.object));
                        code.words.push_back(name == "inherit" ? WGMD_INHERIT : m >= 0 ? mod_of[m] : NONE);
                    }
                }
                rec[MOD_EXTRA] = p.lobe;
                rec[MOD_FLAGS] |= uint32_t(p.lobe_count) << MF_LOBES_SHIFT;
                if (!p.file.empty()) rec[MOD_EXTRA] = bsdf_file(p.file, scene.place(t));
            }
            if (t.type == Type::antimatter) {  // the number of this one, its cut face, and a mark on what it lists
                if (antimatters > 3)
                    base::fail(scene.place(t), "more than four antimatter materials are not supported");
                args.push_back(float(antimatters));
                for (size_t k = 0; k < scene.strings(t).size(); k++) {
                    const int32_t m = scene.lookup_modifier(scene.strings(t)[k], uint32_t(r.object));
                    if (m < 0) continue;
                    if (k == 0) rec[MOD_BRANCH1] = mod_of[m];
                    passes[m] = 1;
                    if (mod_of[m] != NONE)
                        mods[mod_of[m] * MOD_WORDS + MOD_FLAGS] |= 1u << (MF_CLIPPED_SHIFT + antimatters);
                }
                antimatters++;
                out.antimatter = true;
            }
            if (t.type == Type::mist) {  // absent arguments: no extinction; the albedo and eccentricity around it stay
                rec[MOD_EXTRA] = 0;
                rec[MOD_FLAGS] |= (reals.size() > 3 ? MF_ALBEDO : 0) | (reals.size() > 6 ? MF_ECCENTRICITY : 0);
                mists.push_back({uint32_t(mods.size() / MOD_WORDS), uint32_t(r.object)});
            }
            if (eye_passes(scene, t)) rec[MOD_FLAGS] |= MF_SEEN_THROUGH;
            has_material[i] = 1;
            passes[i] = light_passes(scene, t, options.bv);
            material_of[i] = uint32_t(r.object);
        } else {
            const cal::Program p = cal::compile_pattern(library, spec_of(scene, t), code);
            rec[MOD_PROGRAM] = p.entry;
            if (is_mixture(t.type)) {
                rec[MOD_TYPE] = M_MIXTURE;
                const auto b = branches(t, uint32_t(r.object));
                bool any = false, pass = false;
                int inside = 0;
                for (int k = 0; k < 2; k++) {
                    const int32_t m = k ? b.second : b.first;
                    const bool material = m >= 0 && has_material[m];
                    if (m >= 0) rec[MOD_BRANCH1 + k] = mod_of[m];
                    if (m >= 0) inside = std::max(inside, nesting[m]);
                    any = any || material;
                    pass = pass || !material || passes[m];
                }
                if (any && r.modifier >= 0)
                    base::fail(scene.place(scene.objects[i]), "a mixture of materials cannot have a modifier");
                has_material[i] = any || above;
                passes[i] = any ? pass : (above && passes[r.modifier]);
                if (!any) rec[MOD_FLAGS] |= MF_PATTERNS_ONLY;
                nesting[i] = std::max(nesting[i], any ? 0 : inside + 1);
                if (nesting[i] > MIX_DEPTH)
                    base::fail(scene.place(t),
                               fmt::format("more than {} mixtures of patterns one inside the other", MIX_DEPTH));
                if (!any && above) material_of[i] = material_of[r.modifier];
            } else {
                rec[MOD_TYPE] = mod_type(p.kind);
                has_material[i] = above;
                passes[i] = above && passes[r.modifier];
                if (above) material_of[i] = material_of[r.modifier];
            }
        }
        mod_of[i] = uint32_t(mods.size() / MOD_WORDS);
        mods.insert(mods.end(), rec, rec + MOD_WORDS);
    }
}

}  // namespace trace
