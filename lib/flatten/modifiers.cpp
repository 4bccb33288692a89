// SPDX-License-Identifier: BSD-3-Clause
// Modifiers precede their users, so one pass down marks the used ones and one pass up builds them, without recursion
// (chains may be 10,000 deep).
#include "flatten/modifiers.h"

#include <algorithm>
#include <fmt/core.h>

#include "base/error.h"
#include "base/find_file.h"
#include "cal/pattern.h"
#include "flatten/band_colours.h"
#include "flatten/named_modifiers.h"
#include "flatten/reflectance.h"
#include "scene/bsdf_xml.h"
#include "scene/materials.h"

namespace flatten {
namespace {

uint32_t mod_type(cal::ProgramKind k) {
    switch (k) {
    case cal::ProgramKind::brightness: return M_PATTERN1;
    case cal::ProgramKind::color: return M_PATTERN3;
    case cal::ProgramKind::texture: return M_TEXTURE;
    default: return M_MIXTURE;
    }
}

class ModifierWriter {
public:
    ModifierWriter(Modifiers& out, const Options& options, const scene::ReadOptions& files, ModifierTables& tables)
        : scene_(out.scene),
          options_(options),
          files_(files),
          tables_(tables),
          library_(files),
          out_(out),
          uses_(options.bands ? spectral_uses(scene_) : SpectralUses()) {}

    void run(Range users, const std::vector<int32_t>& also_used) {
        const std::vector<uint8_t> needed = needed_modifiers(scene_, users.begin, users.end, also_used);
        for (size_t i = 0; i < needed.size(); i++)
            if (needed[i] && out_.record[i] == NONE) add(i);
    }

private:
    // One modifier of a chain.
    struct Link {
        size_t index;     // of the object in the chain
        const Object& o;  // with its aliases resolved: type and arguments
        int32_t object;   // its index
        int32_t above;    // the next modifier of the chain, VOID if none
        bool above_ends;  // the chain of that modifier has a material
        Modifier record;
    };

    void add(size_t i) {
        const auto r = scene_.resolve(int32_t(i));
        Link link{i,
                  scene_.objects[r.object],
                  r.object,
                  r.modifier,
                  r.modifier >= 0 && out_.has_material[r.modifier],
                  {0, 0, NONE, NONE, uint32_t(tables_.arguments.size()), NONE, NONE, NONE, NONE, NONE, 0, 0, 0}};
        if (r.modifier >= 0) {
            link.record.next = out_.record[r.modifier];
            out_.nesting[i] = out_.nesting[r.modifier];
            out_.patterned[i] = out_.patterned[r.modifier];
        }
        tables_.code.reads = 0;
        if (scene::is_material(link.o.type)) add_material(link);
        else if (is_mixture(link.o.type)) add_mixture(link);
        else add_pattern(link);
        link.record.flags |= dependence(link);
        out_.record[i] = uint32_t(tables_.records.size());
        tables_.records.push_back(link.record);
        if (options_.names)
            tables_.names.push_back(
                {scene_.name(scene_.objects[i]), scene::type_name(link.o.type), scene_.place(link.o)});
    }

    cal::PatternSpec spec_of(const Link& link) const {
        return pattern_spec(options_.bands.get(), uses_, scene_, link.index, link.o);
    }

    // Dependence of the modifier and its parts: MF_LOOKS, MF_TOTAL, MF_PLACE.
    uint32_t dependence(const Link& link) const {
        constexpr uint32_t all = MF_LOOKS | MF_TOTAL | MF_PLACE;
        const unsigned reads = tables_.code.reads;
        uint32_t out = ((reads & cal::READS_RAY) != 0 ? MF_LOOKS : 0) |
                       ((reads & cal::READS_TOTAL) != 0 ? MF_TOTAL : 0) |
                       ((reads & cal::READS_PLACE) != 0 ? MF_PLACE : 0);
        const auto inherit = [&](int32_t m) {
            if (m >= 0) out |= tables_.records[out_.record[m]].flags & all;
        };
        inherit(link.above);
        for (const int32_t part : named_modifiers(scene_, uint32_t(link.object))) inherit(part);
        return out;
    }

    // ---- textures and patterns

    void add_pattern(Link& link) {
        const cal::Program p = cal::compile_pattern(library_, spec_of(link), tables_.code);
        link.record.program = p.entry;
        link.record.type = mod_type(p.kind);
        if (p.kind != cal::ProgramKind::texture) out_.patterned[link.index] = 1;
        out_.has_material[link.index] = link.above_ends;
        out_.is_met[link.index] = link.above >= 0 && out_.is_met[link.above];
        out_.passes[link.index] = !link.above_ends || out_.passes[link.above];
        if (link.above_ends) out_.material[link.index] = out_.material[link.above];
    }

    void add_mixture(Link& link) {
        link.record.program = cal::compile_pattern(library_, spec_of(link), tables_.code).entry;
        link.record.type = M_MIXTURE;
        bool materials = false, passes = false;
        int inside = 0;
        const std::vector<int32_t> branches = named_modifiers(scene_, uint32_t(link.object));
        for (size_t k = 0; k < 2; k++) {
            const int32_t m = branches[k];
            const bool material = m >= 0 && out_.has_material[m];
            if (m >= 0) (k == 0 ? link.record.branch1 : link.record.branch2) = out_.record[m];
            if (m >= 0) inside = std::max(inside, out_.nesting[m]);
            materials = materials || material;
            passes = passes || !material || out_.passes[m];
        }
        if (materials && link.above >= 0)
            base::fail(scene_.place(scene_.objects[link.index]), "a mixture of materials cannot have a modifier");
        if (!materials) link.record.flags |= MF_PATTERNS_ONLY, out_.patterned[link.index] = 1;

        int& nesting = out_.nesting[link.index];
        nesting = std::max(nesting, materials ? 0 : inside + 1);
        if (nesting > MIX_DEPTH)
            base::fail(scene_.place(link.o),
                       fmt::format("more than {} mixtures of patterns one inside the other", MIX_DEPTH));

        out_.has_material[link.index] = materials || link.above_ends;
        out_.is_met[link.index] = 1;
        out_.passes[link.index] = materials ? passes : !link.above_ends || out_.passes[link.above];
        if (!materials && link.above_ends) out_.material[link.index] = out_.material[link.above];
    }

    // ---- materials: their row (kernels/material/materials.h), then special cases

    void add_material(Link& link) {
        const Object& o = link.o;
        if (link.above_ends) {
            const Object& named = scene_.objects[link.index];
            base::fail(scene_.place(named),
                       fmt::format("material \"{}\" has another material above it", scene_.name(named)));
        }
        check_reflectance(scene_, o, is_patterned(link), options_.any_reflectance);
        const scene::Material& row = scene::material_row(o.type);
        link.record.type = row.number;
        link.record.flags = row.flags;
        if ((row.traits & MT_MEDIUM) != 0) tables_.media = true;
        if ((row.traits & MT_BENDS) != 0) tables_.bends = true;
        for (double a : arguments_of(options_.bands.get(), uses_, scene_, link.index, o))
            tables_.arguments.push_back(float(a));
        if (scene_.reals(o).size() < row.filled) tables_.arguments.resize(link.record.args + row.filled, row.fill);

        if (has_alternate(scene_, o)) add_alternate(link);
        else if (o.type == Type::mirror || o.type == Type::illum) link.record.flags |= MF_ALTERNATE_PASSES;
        if (cal::has_functions(type_name(o.type))) add_functions(link);
        if (o.type == Type::antimatter) add_antimatter(link);
        if (o.type == Type::mist) add_mist(link);
        if (eye_passes(scene_, o)) link.record.flags |= MF_SEEN_THROUGH;

        out_.has_material[link.index] = out_.is_met[link.index] = 1;
        out_.passes[link.index] = light_passes(scene_, o, options_.bv);
        out_.material[link.index] = uint32_t(link.object);
    }

    // Returns true if a pattern multiplies its colours: one above it or, of a WGMDfunc, of its components.
    bool is_patterned(const Link& link) const {
        const auto some = [&](int32_t m) { return m >= 0 && out_.patterned[m] != 0; };
        if (link.o.type != Type::WGMDfunc) return some(link.above);
        const std::vector<int32_t> components = named_modifiers(scene_, uint32_t(link.object));
        return some(link.above) || std::any_of(components.begin(), components.end(), some);
    }

    void add_alternate(Link& link) {
        const int32_t m = scene_.lookup_modifier(scene_.strings(link.o)[0], link.object);
        link.record.flags |= MF_HAS_ALTERNATE;
        if (m >= 0) link.record.branch1 = out_.record[m];
        const bool nothing = m < 0 || !out_.has_material[m], mixed = !nothing && out_.material[m] == NONE;
        if (nothing || (!mixed && mirror_gives_way(scene_, scene_.objects[out_.material[m]])))
            link.record.flags |= MF_ALTERNATE_PASSES;
    }

    void add_functions(Link& link) {
        tables_.functions = true;
        cal::Code& code = tables_.code;
        const cal::MaterialProgram p = cal::compile_material(library_, spec_of(link), code);
        link.record.program = p.values;
        link.record.lobe_program = p.lobe;
        link.record.flags |= (p.value_count > 0 ? MF_VALUES : 0) | uint32_t(p.lobe_count) << MF_LOBES_SHIFT;
        if (link.o.type == Type::WGMDfunc) {
            uint32_t* const to[] = {&link.record.rs_mod, &link.record.ts_mod, &link.record.td_mod};
            for (size_t i = 0; i < 3; i++) {
                const std::string& name = scene_.strings(link.o)[size_t(wgmd_names[i])];
                const int32_t m = name == "inherit" ? scene::VOID : scene_.lookup_modifier(name, link.object);
                *to[i] = name == "inherit" ? WGMD_INHERIT : m >= 0 ? out_.record[m] : NONE;
            }
        }
        if (!p.file.empty()) link.record.bsdf_at = bsdf_file(p.file, scene_.place(link.o));
    }

    // A BSDF file, found along RAYPATH: Modifier.bsdf_at.
    uint32_t bsdf_file(const std::string& name, const std::string& place) {
        const std::string path = base::find_file(name, files_, place);
        const auto known = bsdf_files_.find(path);
        if (known != bsdf_files_.end()) return known->second;
        return bsdf_files_[path] = add_bsdf(scene::read_bsdf(path, files_.opener(place)), options_.bands.get(),
                                            tables_.bsdfs, tables_.code, path);
    }

    // Sets its number and its cut face, and marks the modifiers that it lists.
    void add_antimatter(Link& link) {
        if (antimatters_ > 3) base::fail(scene_.place(link.o), "more than four antimatter materials are not supported");
        tables_.arguments.push_back(float(antimatters_));
        const std::vector<int32_t> listed = named_modifiers(scene_, uint32_t(link.object));
        for (size_t k = 0; k < listed.size(); k++) {
            const int32_t m = listed[k];
            if (m < 0) continue;
            if (k == 0) link.record.branch1 = out_.record[m];
            out_.passes[m] = 1;
            if (out_.record[m] != NONE)
                tables_.records[out_.record[m]].flags |= 1u << (MF_CLIPPED_SHIFT + antimatters_);
        }
        antimatters_++;
        tables_.antimatter = true;
    }

    // Absent arguments: no extinction; albedo and eccentricity of the medium around.
    void add_mist(Link& link) {
        const size_t given = scene_.reals(link.o).size();
        link.record.flags |= (given > 3 ? MF_ALBEDO : 0) | (given > 6 ? MF_ECCENTRICITY : 0);
        out_.mists.push_back({uint32_t(tables_.records.size()), uint32_t(link.object)});
    }

    const scene::Scene& scene_;
    const Options& options_;
    const scene::ReadOptions& files_;
    ModifierTables& tables_;
    cal::Library library_;
    std::map<std::string, uint32_t> bsdf_files_;  // tables by path
    uint32_t antimatters_ = 0;
    Modifiers& out_;
    SpectralUses uses_;  // with bands
};

}  // namespace

Modifiers::Modifiers(const scene::Scene& s, ModifierLists known) : ModifierLists(std::move(known)), scene(s) {
    const size_t count = s.objects.size();
    record.resize(count, NONE), material.resize(count, NONE), nesting.resize(count, 0);
    for (std::vector<uint8_t>* list : {&has_material, &is_met, &passes, &patterned}) list->resize(count, 0);
}

bool Modifiers::is_clear(int32_t m) const {
    if (material[m] == NONE) return false;
    const Object& o = scene.objects[material[m]];
    return o.type != Type::antimatter && mirror_gives_way(scene, o);
}

void flatten_modifiers(Modifiers& modifiers, Range users, const std::vector<int32_t>& also_used, const Options& options,
                       const scene::ReadOptions& files, ModifierTables& tables) {
    ModifierWriter(modifiers, options, files, tables).run(users, also_used);
}

void write_modifiers(ModifierTables t, FlatScene& out) {
    out.u = std::move(t.code.words);
    out.f = std::move(t.code.floats);
    const uint32_t args_at = uint32_t(out.f.size());
    out.f.insert(out.f.end(), t.arguments.begin(), t.arguments.end());
    for (size_t i = t.written; i < t.records.size(); i++) t.records[i].args += args_at;
    out.modifiers = std::move(t.records);
    out.bsdf_components = std::move(t.bsdfs.components);
    out.bsdf_tables = std::move(t.bsdfs.tables);
    out.bsdf_rings = std::move(t.bsdfs.rings);
    if (t.bends) out.shadows_need(SHADOW_AIMED);
    out.absorbs = out.absorbs || t.media;
    out.antimatter = out.antimatter || t.antimatter;
    out.functions = out.functions || t.functions;
    out.modifier_names = std::move(t.names);
}

ModifierTables take_modifiers(FlatScene& out, std::map<std::string, uint32_t> files) {
    ModifierTables t;
    t.code.words = std::move(out.u), t.code.floats = std::move(out.f), t.code.tables = std::move(files);
    t.bsdfs = {std::move(out.bsdf_components), std::move(out.bsdf_tables), std::move(out.bsdf_rings)};
    t.records = std::move(out.modifiers), t.names = std::move(out.modifier_names);
    t.written = t.records.size();
    return t;
}

}  // namespace flatten
