// SPDX-License-Identifier: BSD-3-Clause
// Textures, patterns and mixtures to programs (spec: scene language 5).  To add a type: a row in `types` and its
// function.
#include "cal/pattern.h"
#include <cmath>
#include "base/error.h"
#include "cal/pattern_parts.h"
#include "cal/spectrum.h"
#include "image/picture.h"

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

// R, G, B of a picture at u, v after the .cal file
Nodes picture_values(Parts& p, size_t picture, size_t cal) {
    p.file(cal);
    const Nodes x = p.coordinates(cal + 1);
    if (x.size() != 2) p.fail("a picture needs two coordinates");
    const int look = p.graph->lookup(OP_DATA, {x[1], x[0]}, p.picture(picture), 3);
    return {p.graph->channel(look, 0), p.graph->channel(look, 1), p.graph->channel(look, 2)};
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

// ---- spectral types: RGB by the colour matching functions, as RADIANCE's RGB mode does
constexpr double step_nm = 10;  // nm, where a function is sampled for each point

// A colour outside the triangle of the primaries is moved towards the grey of its luminance.
void inside_gamut(Parts& p, Nodes rgb, Nodes& out) {
    Graph& g = *p.graph;
    int y = g.constant(0);
    for (size_t k = 0; k < 3; k++) y = g.add(y, g.mul(rgb[k], g.constant(image::luminance_weights[k])));
    const int least = g.make(OP_MIN, g.make(OP_MIN, rgb[0], rgb[1]), rgb[2]);
    const int share =
        g.choose(g.make(OP_NEG, least), g.choose(y, g.make(OP_DIV, y, g.sub(y, least)), g.constant(0)), g.constant(1));
    for (int c : rgb) out.push_back(g.choose(y, g.add(y, g.mul(g.sub(c, y), share)), g.constant(0)));
}

void constant_spectrum(Parts& p, const std::function<double(double)>& f, Nodes& out) {
    Nodes rgb;
    for (double v : spectrum_rgb(f, 1)) rgb.push_back(p.graph->constant(v));
    inside_gamut(p, rgb, out);
}

template <class F>
void sampled_spectrum(Parts& p, double low, double high, F value, Nodes& out) {
    Nodes rgb(3, p.graph->constant(0));
    for (double nm = 380 + step_nm / 2; nm < 780; nm += step_nm) {
        if (nm < low || nm > high) continue;
        const std::array<double, 3> w = spectrum_weight(nm, step_nm);
        const int v = value(p.graph->constant(nm));
        for (size_t k = 0; k < 3; k++) rgb[k] = p.graph->add(rgb[k], p.graph->mul(v, p.graph->constant(w[k])));
    }
    inside_gamut(p, rgb, out);
}

// Values at even steps from the first wavelength to the last, both included; 0 outside.
void spectrum(Parts& p, Nodes& out) {
    const std::vector<double>& r = p.spec.reals;
    if (r.size() < 5) p.fail("bad number of real arguments");
    const double first = r[0], last = r[1];
    if (first == last) p.fail("a spectrum needs two different wavelengths");
    if (r.size() == 5 && std::fabs(first - last) == 400 && std::fmax(first, last) == 780) {  // R, G, B themselves
        for (size_t k = 0; k < 3; k++) out.push_back(p.graph->constant(r[2 + (first > last ? k : 2 - k)]));
        return;
    }
    const double intervals = double(r.size() - 3);
    constant_spectrum(
        p,
        [&](double nm) {
            const double t = (nm - first) / (last - first) * intervals;
            if (t < 0 || t > intervals) return 0.0;
            const size_t i = size_t(std::fmin(t, intervals - 1));
            return r[2 + i] + (r[3 + i] - r[2 + i]) * (t - double(i));
        },
        out);
}

void specfile(Parts& p, Nodes& out) {
    const DataFile data = p.read(0);
    if (data.dimensions.size() != 1) p.fail("a spectrum has one dimension, wavelength");
    const DataFile::Dimension& d = data.dimensions[0];
    constant_spectrum(
        p,
        [&](double nm) {
            for (uint32_t i = 0; i + 1 < d.count; i++) {
                const double t = (nm - d.at(i)) / (d.at(i + 1) - d.at(i));
                if (t >= 0 && t <= 1) return data.values[i] + (data.values[i + 1] - data.values[i]) * t;
            }
            return 0.0;
        },
        out);
}
void specfunc(Parts& p, Nodes& out) {
    if (p.spec.reals.size() < 2) p.fail("bad number of real arguments");
    p.file(1);
    p.no_more_than_transform(2);
    const double a = p.spec.reals[0], b = p.spec.reals[1];
    sampled_spectrum(
        p, std::fmin(a, b), std::fmax(a, b), [&](int nm) { return p.call(0, {nm}); }, out);
}
void specdata(Parts& p, Nodes& out) {
    p.file(2);
    const Nodes x = p.coordinates(3);
    const uint32_t table = p.data(1, x.size() + 1);
    sampled_spectrum(
        p, 380, 780,
        [&](int nm) {
            Nodes at = x;
            at.push_back(nm);
            return p.call(0, {p.graph->channel(p.graph->lookup(OP_DATA, at, table), 0), nm});
        },
        out);
}
// An RGB picture's channels stand for the middles of the bands 780-588, 588-480, 480-380.  In a hyperspectral one each
// band is constant over its wavelengths.
void specpict(Parts& p, Nodes& out) {
    const auto spectral = p.spectral(1);
    if (!spectral) {
        const double middles[3] = {684, 534, 430};
        const Nodes rgb = picture_values(p, 1, 2);
        for (size_t k = 0; k < 3; k++) out.push_back(p.call(0, {rgb[k], p.graph->constant(middles[k])}));
        return;
    }
    p.file(2);
    const Nodes x = p.coordinates(3);
    if (x.size() != 2) p.fail("a picture needs two coordinates");
    Nodes rgb(3, p.graph->constant(0));
    const double width = (spectral->to - spectral->from) / spectral->bands;
    for (int band = 0; band < spectral->bands; band++) {
        const double begin = spectral->from + band * width;
        const int look = p.graph->lookup(OP_DATA, {x[1], x[0]}, spectral->tables[size_t(band / 3)], 3);
        const int v = p.call(0, {p.graph->channel(look, band % 3), p.graph->constant(begin + width / 2)});
        const std::array<double, 3> w = band_weight(begin, begin + width);
        for (size_t k = 0; k < 3; k++) rgb[k] = p.graph->add(rgb[k], p.graph->mul(v, p.graph->constant(w[k])));
    }
    inside_gamut(p, rgb, out);
}

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
    {"mixtext", 4, ProgramKind::mixture, mixtext},          {"spectrum", 0, ProgramKind::color, spectrum},
    {"specfile", 1, ProgramKind::color, specfile},          {"specdata", 4, ProgramKind::color, specdata},
    {"specfunc", 2, ProgramKind::color, specfunc},          {"specpict", 5, ProgramKind::color, specpict},
};

const Type* type_of(const std::string& name) {
    for (const Type& t : types)
        if (name == t.name) return &t;
    return nullptr;
}

}  // namespace

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
        return out;
    });
    return program;
}

}  // namespace cal
