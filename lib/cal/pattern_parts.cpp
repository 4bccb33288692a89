// SPDX-License-Identifier: BSD-3-Clause
// Strings of a pattern to graph nodes (pattern_parts.h).
#include "cal/pattern_parts.h"
#include <cmath>
#include "base/error.h"
#include "base/split.h"

namespace cal {

Parts::Parts(Library& library, const PatternSpec& pattern, Code& code) : spec(pattern), library_(library), code_(code) {
    // Text patterns have no transform; their words may look like one.
    if (base::ends_with(spec.type, "text")) {
        xform_ = spec.outer;
        return;
    }
    const size_t at = transform_at(0);
    base::Xform own;
    if (at < spec.strings.size()) {
        const base::Span<std::string> words{spec.strings.data(), spec.strings.size()};
        const int used = base::parse_xform(words, at, own, spec.place);
        if (at + size_t(used) != spec.strings.size())
            fail("\"" + spec.strings[at + size_t(used)] + "\" is not a transform");
    }
    xform_ = base::multiply(own, spec.outer);
    if (xform_.scale == 0) fail("transform without inverse");
}

void Parts::fail(const std::string& fact) const { base::fail(spec.place, fact); }

uint32_t Parts::compile(const std::function<std::vector<int>()>& make) {
    return with_builder(library_, spec.reals, xform_, spec.place, code_, [&](GraphBuilder& b, Graph& g) {
        builder_ = &b;
        graph = &g;
        return make();
    });
}

void Parts::file(size_t at) {
    if (at >= spec.strings.size()) fail("bad arguments: the function file is missing");
    context_ = library_.state().load(spec.strings[at], spec.place);
}

size_t Parts::transform_at(size_t from) const {
    while (from < spec.strings.size() && !base::is_xform_option(spec.strings[from])) from++;
    return from;
}

void Parts::no_more_than_transform(size_t at) const {
    if (transform_at(at) != at) fail("bad arguments: \"" + spec.strings[at] + "\" after the function file");
}

int Parts::expression(size_t at) {
    return builder_->expression(parse_expression(spec.strings[at], spec.place, library_.state().pool), context_);
}

int Parts::parameters(size_t at) { return builder_->parameters(spec.strings[at], context_); }

int Parts::call(size_t at, const std::vector<int>& values) {
    if (parameters(at) < 0) fail("function \"" + spec.strings[at] + "\" is not defined");
    return builder_->call(spec.strings[at], values, context_);
}

std::vector<int> Parts::coordinates(size_t from) {
    std::vector<int> x;
    for (size_t i = from; i < transform_at(from); i++) x.push_back(expression(i));
    if (x.empty()) fail("bad arguments: coordinates are missing");
    if (x.size() > 5) fail("more than 5 coordinates");
    return x;
}

std::vector<int> Parts::coordinates_of(size_t from, const std::vector<int>& values) {
    std::vector<int> x;
    for (size_t i = from; i < transform_at(from); i++)
        x.push_back(parameters(i) >= 0 ? call(i, values) : expression(i));
    if (x.empty()) fail("bad arguments: coordinates are missing");
    if (x.size() > 5) fail("more than 5 coordinates");
    return x;
}

uint32_t Parts::data(size_t at, size_t dimensions) {
    return data_table(library_.state(), spec.strings[at], dimensions, spec.place, code_);
}
std::optional<SpectralTables> Parts::spectral(size_t at) {
    return spectral_tables(library_.state(), spec.strings[at], spec.place, code_);
}
uint32_t Parts::picture(size_t at) { return picture_table(library_.state(), spec.strings[at], spec.place, code_); }

DataFile Parts::read(size_t at) {
    const base::ReadOptions& files = library_.state().files;
    return read_data(base::find_file(spec.strings[at], files, spec.place), files.opener(spec.place));
}

// Column and row of the point in the skewed grid of R and D (dual vectors), then the characters' own scale.
int Parts::text(size_t font_at, size_t real_count) {
    const std::vector<double>& r = spec.reals;
    if (r.size() != real_count && r.size() != real_count + 1) fail("bad number of real arguments");
    if (spec.strings.size() < font_at + 2) fail("bad arguments: font and text are missing");
    const base::Vec3 origin{r[0], r[1], r[2]}, right{r[3], r[4], r[5]}, down{r[6], r[7], r[8]};
    const base::Vec3 n = base::cross(down, right);
    const double n2 = base::dot(n, n);
    if (!(n2 > 0)) fail("text vectors are parallel or zero");
    const base::Vec3 column = base::cross(n, down) * (1 / n2), row = base::cross(right, n) * (1 / n2);

    const base::ReadOptions& files = library_.state().files;
    const base::Opener by = files.opener(spec.place);
    const Font font = read_font(base::find_file(spec.strings[font_at], files, spec.place), by);
    std::vector<std::string> lines;
    if (spec.strings[font_at + 1] == ".") {
        std::string line;
        for (size_t i = font_at + 2; i < spec.strings.size(); i++)
            line += (i > font_at + 2 ? " " : "") + spec.strings[i];
        lines.push_back(line);
    } else {
        const std::string path = base::find_file(spec.strings[font_at + 1], files, spec.place);
        const std::string text = read_text(path, size_t(16) << 20, by);
        for (size_t from = 0; from < text.size();) {
            const size_t end = std::min(text.find('\n', from), text.size());
            lines.push_back(text.substr(from, end - from));
            from = end + 1;
        }
    }
    double units = 255;
    int spacing = 0;
    if (r.size() > real_count) {
        const double g = r[real_count];
        if (!(std::fabs(g) < 1000)) fail("bad text spacing");
        units = font.mean_width + 255 * std::fabs(g);
        spacing = int(255 * g);
    }
    const uint32_t table = text_table(font, lines, spacing, code_);
    auto along = [&](const base::Vec3& v, double scale) {
        int sum = graph->constant(-base::dot(origin, v) * scale);
        const char* const names[3] = {"Px", "Py", "Pz"};
        for (int k = 0; k < 3; k++) {
            const int p = builder_->expression(parse_expression(names[k], spec.place, library_.state().pool), "");
            sum = graph->add(sum, graph->mul(p, graph->constant(v[k] * scale)));
        }
        return sum;
    };
    return graph->lookup(OP_TEXT, {along(column, units), along(row, 1)}, table);
}

std::vector<int> Parts::to_world(const std::vector<int>& v) {
    std::vector<int> out;
    const double scale = std::fabs(xform_.scale);
    for (int axis = 0; axis < 3; axis++) {
        int sum = graph->constant(0);
        for (int k = 0; k < 3; k++) {
            const double m = xform_.m[k][axis] / scale;
            if (std::fabs(m) > 1e-15) sum = graph->add(sum, graph->mul(v[size_t(k)], graph->constant(m)));
        }
        out.push_back(sum);
    }
    return out;
}

}  // namespace cal
