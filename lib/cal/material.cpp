// SPDX-License-Identifier: BSD-3-Clause
// Function materials: which of their strings are values of a hit, which a lobe of the light direction (pattern.h).
#include "base/error.h"
#include "base/split.h"
#include "cal/pattern_parts.h"
#include "cal/spectral_patterns.h"
#include "kernels/material/materials.h"

namespace cal {

namespace {

using Nodes = std::vector<int>;

// coef dx dy dz, the direction turned to the world
void prism_exit(Parts& p, size_t first, Nodes& out) {
    out.push_back(p.expression(first));
    for (int n : p.to_world({p.expression(first + 1), p.expression(first + 2), p.expression(first + 3)}))
        out.push_back(n);
}
void direction(Parts& p, size_t first, Nodes& out) {
    for (int n : p.to_world({p.expression(first), p.expression(first + 1), p.expression(first + 2)})) out.push_back(n);
}
// Light direction and solid angle as given to the program
Nodes light(Parts& p, GraphBuilder& b, Library& library) {
    Nodes l;
    for (const char* channel : {"$101", "$102", "$103", "$104"})
        l.push_back(b.expression(parse_expression(channel, p.spec.place, library.state().pool), ""));
    return l;
}

#define KIND_OF_ROW(number, type, strings, reals, absent, values, lobe, light, eye, region, back, traits) \
    {#type, strings, values, lobe},
const struct Kind {
    const char* name;
    size_t strings;
    int values, lobe;
} kinds[] = {MATERIALS(KIND_OF_ROW, KIND_OF_ROW)};
#undef KIND_OF_ROW

const Kind* kind_of(const std::string& name) {
    for (const Kind& k : kinds)
        if (k.values + k.lobe > 0 && name == k.name) return &k;
    return nullptr;
}

}  // namespace

bool has_functions(const std::string& type) { return kind_of(type) != nullptr; }

MaterialProgram compile_material(Library& library, const PatternSpec& spec, Code& code) {
    const Kind* kind = kind_of(spec.type);
    if (!kind) base::fail(spec.place, "\"" + spec.type + "\" has no functions");
    if (spec.strings.size() < kind->strings) base::fail(spec.place, "bad arguments: too few strings for " + spec.type);
    MaterialProgram m;
    m.value_count = kind->values;
    m.lobe_count = kind->lobe;
    Parts p(library, spec, code);
    const std::string& type = spec.type;
    if (base::ends_with(type, "data")) {
        m.lobe = p.compile([&] {
            p.file(2);
            const Nodes l = light(p, p.builder(), library);
            const Nodes x = p.coordinates_of(3, l);
            Nodes arguments{p.graph->channel(p.graph->lookup(OP_DATA, x, p.data(1, x.size())), 0)};
            arguments.insert(arguments.end(), l.begin(), l.end());
            return Nodes{p.call(0, arguments)};
        });
        return m;
    }
    const size_t file = kind->strings - 1;
    p.no_more_than_transform(file + 1);
    if (kind->values)
        m.values = p.compile([&] {
            Nodes out;
            p.file(file);
            if (type == "prism1" || type == "prism2") {
                for (size_t first = 0; first < file; first += 4) prism_exit(p, first, out);
            } else if (type == "BRTDfunc") {
                for (size_t i = 0; i < 6; i += 3)
                    for (int n : in_bands(p, {p.expression(i), p.expression(i + 1), p.expression(i + 2)}))
                        out.push_back(n);
            } else if (type == "WGMDfunc") {
                for (size_t i : {1, 2, 3, 5, 6, 7}) out.push_back(p.expression(i));
                direction(p, 9, out);
            } else {
                if (type == "BSDF") out.push_back(p.expression(0));
                direction(p, file - 3, out);
            }
            return out;
        });
    if (kind->lobe)
        m.lobe = p.compile([&] {
            Nodes out;
            p.file(file);
            const Nodes l = light(p, p.builder(), library);
            const size_t first = file - size_t(kind->lobe);
            for (size_t i = first; i < file; i++)
                out.push_back(spec.strings[i] == "0" ? p.graph->constant(0) : p.call(i, l));
            return type == "BRTDfunc" ? in_bands(p, out) : out;
        });
    if (type == "WGMDfunc") m.modifiers = {spec.strings[0], spec.strings[4], spec.strings[8]};
    if (type == "BSDF") m.file = spec.strings[1];
    if (type == "aBSDF") m.file = spec.strings[0];
    return m;
}

}  // namespace cal
