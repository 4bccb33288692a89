// SPDX-License-Identifier: BSD-3-Clause
// Modifier chains as records (kernels/records.h).
#pragma once
#include <cstdint>
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
    cal::Code code;  // programs: become the start of both arenas, for their addresses are absolute
    std::vector<kernels::Modifier> records;
    BsdfRecords bsdfs;
    std::vector<float> arguments;  // real ones; Modifier.args counts from their start
    bool bends = false;            // some material is MT_BENDS
    bool media = false;            // MT_MEDIUM
    bool antimatter = false;
    bool functions = false;              // some material has .cal functions or tables
    std::vector<FlatScene::Name> names;  // of the records, with Options::names
};

// The modifiers of one scene, by the index of the object.
struct Modifiers {
    explicit Modifiers(const scene::Scene& scene);  // none is used yet

    const scene::Scene& scene;
    std::vector<uint32_t> record;       // NONE: not used by any surface
    std::vector<uint8_t> has_material;  // the chain from here ends in one, or in a mixture of some
    std::vector<uint8_t> is_met;        // rays meet its surfaces: it has one, or a mixture, even of nothing
    std::vector<uint8_t> passes;        // a shadow ray may pass
    std::vector<uint32_t> material;     // object of the chain's material, aliases resolved; NONE: a mixture, or none
    bool is_clear(int32_t m) const;     // that is of a transparent type (PRIM_CLEAR)

    struct Mist {
        uint32_t record, object;
    };
    std::vector<Mist> mists;
};

// Only what surfaces use, and what `also_used` names, is compiled.
Modifiers flatten_modifiers(const scene::Scene& scene, const std::vector<int32_t>& also_used, const Options& options,
                            const scene::ReadOptions& files, ModifierTables& tables);

// Into the arenas, which are still empty.
void write_modifiers(ModifierTables tables, FlatScene& out);

}  // namespace flatten
