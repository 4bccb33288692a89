// SPDX-License-Identifier: BSD-3-Clause
// Modifier chains as records (kernels/records.h).
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>
#include "cal/compile.h"
#include "flatten/bsdf.h"
#include "flatten/flat_scene.h"
#include "flatten/flatten.h"
#include "kernels/dialect/host.h"
#include "scene/object.h"

namespace flatten {

// Tables that the scene and the octrees of its instances fill together.
struct ModifierTables {
    cal::Code code;  // programs, behind what the arenas hold: their addresses are absolute
    std::vector<kernels::Modifier> records;
    BsdfRecords bsdfs;
    size_t written = 0;            // number of records that an earlier write_modifiers() has written
    std::vector<float> arguments;  // real ones of the rest; Modifier.args counts from their start
    bool bends = false;            // some material is MT_BENDS
    bool media = false;            // MT_MEDIUM
    bool antimatter = false;
    bool functions = false;              // some material has .cal functions or tables
    std::vector<FlatScene::Name> names;  // of the records, with Options::names
};

// Facts about modifiers, by the index of the object.
struct ModifierLists {
    std::vector<uint32_t> record;       // NONE: not used by any surface
    std::vector<uint8_t> has_material;  // the chain from here ends in one, or in a mixture of some
    std::vector<uint8_t> is_met;        // rays meet its surfaces: it has one, or a mixture, even of nothing
    std::vector<uint8_t> passes;        // a shadow ray may pass
    std::vector<uint32_t> material;     // object of the chain's material, aliases resolved; NONE: a mixture, or none
    std::vector<int> nesting;           // of mixtures of patterns, from here on
    std::vector<uint8_t> patterned;     // a pattern from here on

    struct Mist {
        uint32_t record, object;
    };
    std::vector<Mist> mists;
};

// The modifiers of one scene.
struct Modifiers : ModifierLists {
    // known: lists of the first objects; no surface uses the modifiers behind them yet.
    explicit Modifiers(const scene::Scene& scene, ModifierLists known = {});

    const scene::Scene& scene;
    bool is_clear(int32_t m) const;  // the chain's material is of a transparent type (PRIM_CLEAR)
};

// Objects of a scene, one after another.
struct Range {
    size_t begin, end;
};

// Compiles what the surfaces among these objects use, and what `also_used` names.
void flatten_modifiers(Modifiers& modifiers, Range users, const std::vector<int32_t>& also_used, const Options& options,
                       const scene::ReadOptions& files, ModifierTables& tables);

// Into the arenas.
void write_modifiers(ModifierTables tables, FlatScene& out);
// The tables of a scene once more, for further modifiers; files: ModifierTables.code.tables of before.
ModifierTables take_modifiers(FlatScene& out, std::map<std::string, uint32_t> files);

}  // namespace flatten
