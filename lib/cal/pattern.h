// SPDX-License-Identifier: BSD-3-Clause
// Every texture, pattern and mixture of the scene language, and the functions of materials, as programs: for the shader
// all of them are "run the entry, take the outputs".
#pragma once
#include <string>
#include <vector>
#include "base/xform.h"
#include "cal/compile.h"
#include "spectrum/bands.h"

namespace cal {

// A primitive as written in the scene file.  `outer`: transform of the instance or mesh it acts in (object -> world),
// which acts after the one in its own string arguments; identity for most.
struct PatternSpec {
    std::string type;  // "brightfunc", "colorpict", ..
    std::vector<std::string> strings;
    std::vector<double> reals;
    std::string place;  // "office.rad:14", for messages
    base::Xform outer;
    const spectrum::Bands* bands = nullptr;  // in place of R, G and B
    bool of_light = false;                   // with them: it colours lights, else surfaces
};

enum class ProgramKind {
    brightness,  // 1 output, multiplies the colour
    color,       // 3 outputs, multiply the colour
    texture,     // 3 outputs: displacement of the normal, world coordinates
    mixture,     // 1 output, 0 to 1: share of the first modifier
};

struct Program {
    uint32_t entry = 0;
    int outputs = 0;
    ProgramKind kind = ProgramKind::brightness;
    std::string first, second;  // mixtures: names of the modifiers
};

Program compile_pattern(Library& library, const PatternSpec& spec, Code& code);

// Functions of a material.  values: what is needed once per hit; lobe: what is needed per light direction, with
// CAL_LX.. (world) and CAL_OMEGA given.  Directions among the values are in world coordinates.
//   prism1, prism2     values coef dx dy dz (twice for prism2)
//   plastic2 metal2 trans2 ashik2   values ux uy uz
//   plasfunc metfunc transfunc plasdata metdata transdata   lobe f
//   BRTDfunc           values rr rg rb tr tg tb; lobe fr fg fb
//   WGMDfunc           values rs ur vr ts utr vtr ux uy uz; modifiers rs_mod ts_mod td_mod
//   BSDF               values thickness ux uy uz; aBSDF: values ux uy uz
struct MaterialProgram {
    uint32_t values = 0, lobe = 0;  // entries; meaningful if the counts are not 0
    int value_count = 0, lobe_count = 0;
    std::vector<std::string> modifiers;  // WGMDfunc
    std::string file;                    // BSDF, aBSDF: the XML file
};
bool has_functions(const std::string& type);
MaterialProgram compile_material(Library& library, const PatternSpec& spec, Code& code);

}  // namespace cal
