// SPDX-License-Identifier: BSD-3-Clause
// Textures, patterns and mixtures to programs (spec: scene language 5).  To add a type: a row in `types` and its
// function.
#include "cal/pattern.h"
#include <cmath>
#include "base/error.h"
#include "base/split.h"
#include "cal/pattern_parts.h"
#include "cal/spectral_patterns.h"

namespace cal {

namespace {

using Nodes = std::vector<int>;

void func(Parts& p, Nodes& out, size_t count, size_t first) {
    p.file(first + count);
    p.no_more_than_transform(first + count + 1);
    for (size_t i = 0; i < count; i++) out.push_back(p.expression(first + i));
}

// Values of `count` data files at the coordinates after the .cal file, which is string `cal`.
Nodes data_values(Parts& p, size_t first, size_t count, size_t cal) {
    p.file(cal);
    const Nodes x = p.coordinates(cal + 1);
    Nodes values;
    for (size_t i = 0; i < count; i++)
        values.push_back(p.graph->channel(p.graph->lookup(OP_DATA, x, p.data(first + i, x.size())), 0));
    return values;
}

// rf(r,g,b), and gf, bf of three values or of their own
void color_functions(Parts& p, const Nodes& rgb, Nodes& out) {
    for (size_t k = 0; k < 3; k++) out.push_back(k > 0 && p.parameters(k) < 3 ? p.call(k, {rgb[k]}) : p.call(k, rgb));
}

int clamped(Parts& p, int node) {
    Graph& g = *p.graph;
    return g.make(OP_MAX, g.make(OP_MIN, node, g.constant(1)), g.constant(0));
}

void brightfunc(Parts& p, Nodes& out) { func(p, out, 1, 0); }
void colorfunc(Parts& p, Nodes& out) { func(p, out, 3, 0); }
void texfunc(Parts& p, Nodes& out) {
    func(p, out, 3, 0);
    out = p.to_world(out);
}
void mixfunc(Parts& p, Nodes& out) {
    func(p, out, 1, 2);
    out[0] = clamped(p, out[0]);
}
void brightdata(Parts& p, Nodes& out) { out.push_back(p.call(0, data_values(p, 1, 1, 2))); }
void colordata(Parts& p, Nodes& out) { color_functions(p, data_values(p, 3, 3, 6), out); }
void texdata(Parts& p, Nodes& out) {
    const Nodes d = data_values(p, 3, 3, 6);
    for (size_t k = 0; k < 3; k++) out.push_back(p.call(k, d));
    out = p.to_world(out);
}
void mixdata(Parts& p, Nodes& out) { out.push_back(clamped(p, p.call(2, data_values(p, 3, 1, 4)))); }
void colorpict(Parts& p, Nodes& out) { color_functions(p, picture_values(p, 3, 4), out); }
void mixpict(Parts& p, Nodes& out) { out.push_back(clamped(p, p.call(2, picture_values(p, 3, 4)))); }

// Choose between foreground and background of `width` reals each.
void text(Parts& p, Nodes& out, size_t font, size_t width) {
    const int ink = p.text(font, 9 + 2 * width);
    for (size_t k = 0; k < width; k++)
        out.push_back(p.graph->choose(ink, p.graph->constant(p.spec.reals[9 + k]),
                                      p.graph->constant(p.spec.reals[9 + width + k])));
}
void brighttext(Parts& p, Nodes& out) { text(p, out, 0, 1); }
void colortext(Parts& p, Nodes& out) { text(p, out, 0, 3); }
void mixtext(Parts& p, Nodes& out) { out.push_back(p.text(2, 9)); }

const struct Type {
    const char* name;
    size_t strings;
    ProgramKind kind;
    void (*build)(Parts&, Nodes&);
} types[] = {
    {"brightfunc", 2, ProgramKind::brightness, brightfunc}, {"colorfunc", 4, ProgramKind::color, colorfunc},
    {"texfunc", 4, ProgramKind::texture, texfunc},          {"mixfunc", 4, ProgramKind::mixture, mixfunc},
    {"brightdata", 4, ProgramKind::brightness, brightdata}, {"colordata", 8, ProgramKind::color, colordata},
    {"texdata", 8, ProgramKind::texture, texdata},          {"mixdata", 6, ProgramKind::mixture, mixdata},
    {"colorpict", 7, ProgramKind::color, colorpict},        {"mixpict", 7, ProgramKind::mixture, mixpict},
    {"brighttext", 2, ProgramKind::brightness, brighttext}, {"colortext", 2, ProgramKind::color, colortext},
    {"mixtext", 4, ProgramKind::mixture, mixtext},          {"spectrum", 0, ProgramKind::color, spectrum_pattern},
    {"specfile", 1, ProgramKind::color, specfile_pattern},  {"specdata", 4, ProgramKind::color, specdata_pattern},
    {"specfunc", 2, ProgramKind::color, specfunc_pattern},  {"specpict", 5, ProgramKind::color, specpict_pattern},
};

const Type* type_of(const std::string& name) {
    for (const Type& t : types)
        if (name == t.name) return &t;
    return nullptr;
}

// Colours that are R, G and B: all but those of spectra, which fold themselves.
bool is_rgb(const Type& t) { return t.kind == ProgramKind::color && !base::begins_with(t.name, "spec"); }

}  // namespace

Nodes picture_values(Parts& p, size_t picture, size_t cal) {
    p.file(cal);
    const Nodes x = p.coordinates(cal + 1);
    if (x.size() != 2) p.fail("a picture needs two coordinates");
    const int look = p.graph->lookup(OP_DATA, {x[1], x[0]}, p.picture(picture), 3);
    return {p.graph->channel(look, 0), p.graph->channel(look, 1), p.graph->channel(look, 2)};
}

Program compile_pattern(Library& library, const PatternSpec& spec, Code& code) {
    const Type* type = type_of(spec.type);
    if (!type) base::fail(spec.place, "\"" + spec.type + "\" is not a pattern, texture or mixture");
    if (spec.strings.size() < type->strings) base::fail(spec.place, "bad arguments: too few strings for " + spec.type);
    Program program;
    program.kind = type->kind;
    program.outputs = type->kind == ProgramKind::brightness || type->kind == ProgramKind::mixture ? 1 : 3;
    if (type->kind == ProgramKind::mixture) {
        program.first = spec.strings[0];
        program.second = spec.strings[1];
    }
    Parts parts(library, spec, code);
    program.entry = parts.compile([&] {
        Nodes out;
        type->build(parts, out);
        return is_rgb(*type) ? in_bands(parts, out) : out;
    });
    return program;
}

}  // namespace cal
