// SPDX-License-Identifier: BSD-3-Clause
// See row.h.
#include "row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing.h"
#include "evalglare/output.h"

using namespace glare;
using namespace report;

namespace {

bool is_plain(const Options& o) { return o.mode != OutputMode::accelerad; }

bool has_interval(const Options& o, const Column& c) { return o.ci && !c.words; }
bool has_difference(const Options& o, const Column& c) { return !o.against.empty() && !c.words; }

bool is_aligned(const Options& o) { return o.format == TableFormat::aligned; }
constexpr size_t width_with_error = 18;

// "Ev" with "Ev.lo" and "Ev.hi"; for a reader all three are one column.
void add_with_interval(const Options& o, const std::string& name, const Number& n, Line& line) {
    if (is_aligned(o))
        add(line, fmt::format("{:>{}}", name, width_with_error),
            {with_error(std::isnan(n.middle) ? n.value : n.middle, n.off.half_width()), true});
    else add_bounds(line, name, n.value, n.middle + n.off.low, n.middle + n.off.high);
}

size_t longest(const std::vector<std::string>& texts) {
    size_t out = 0;
    for (const std::string& t : texts) out = std::max(out, t.size());
    return out;
}

Line start_of(const Options& o, const Heading& heading, const Row& row) {
    Line out;
    const Cell frame = number_cell(double(row.frame), 15);
    const Cell seconds = number_cell(o.files.empty() ? std::round(row.seconds * 1000) / 1000 : 0, 9);
    if (!is_plain(o)) add(out, "Time", seconds), add(out, "Frame", frame);
    else if (o.files.empty()) add(out, "frame", frame), add(out, "seconds", seconds);
    else add(out, is_aligned(o) ? fmt::format("{:<{}}", "file", longest(o.files)) : "file", text_cell(row.file));
    const auto name = [](const std::string& text) { return text_cell(text.empty() ? "-" : text); };
    if (heading.views) add(out, "view", name(row.view));
    if (heading.skies) add(out, "sky", name(row.sky));
    if (heading.states) add(out, "state", name(row.state));
    if (heading.edits) add(out, "edit", double(row.edit.value_or(0)));
    return out;
}

std::string errors_cell(const Options& o, const std::vector<Column>& columns, const Row& row) {
    std::string cell;
    for (size_t k = 0; k < columns.size(); ++k) {
        if (!columns[k].printed) continue;
        if (has_interval(o, columns[k])) add_error(columns[k].name, row.numbers[k].error, cell);
        if (has_difference(o, columns[k])) add_error(columns[k].name + ".d", row.differences[k].error, cell);
    }
    return cell.empty() ? "-" : cell;
}

void add_columns(const Options& o, const std::vector<Column>& columns, const Row& row, Line& line) {
    for (size_t k = 0; k < columns.size(); ++k) {
        const Column& c = columns[k];
        const Number& n = row.numbers[k];
        if (!c.printed) continue;
        if (has_interval(o, c)) add_with_interval(o, c.name, n, line);
        else
            add(line, c.words && is_aligned(o) ? fmt::format("{:>13}", c.name) : c.name,
                c.words && !std::isnan(n.value) ? Cell{c.words[int(n.value)], is_aligned(o)}
                                                : number_cell(n.value, is_aligned(o) ? 5 : 8));
        if (has_difference(o, c)) add_with_interval(o, c.name + ".d", row.differences[k], line);
    }
    if (o.go_on) add(line, "settled", row.settled);
    if (o.ci)
        add(line, is_aligned(o) ? "tails    " : "tails", text_cell(row.heavy_tailed.empty() ? "-" : row.heavy_tailed));
    if (o.ci && !is_aligned(o)) add(line, errors_column, text_cell(errors_cell(o, columns, row)));
}

void add_source(const Options& o, const GlareSource& s, size_t number, double share, const std::string& outline,
                Line& line) {
    const std::pair<const char*, double> numbers[] = {{"source", double(number)},
                                                      {"pixels", s.pixels},
                                                      {"x", s.x},
                                                      {"y", s.y},
                                                      {"omega", s.omega},
                                                      {"L", s.lum},
                                                      {"P", s.P},
                                                      {"sigma", s.sigma_deg},
                                                      {"xdir", s.direction.x},
                                                      {"ydir", s.direction.y},
                                                      {"zdir", s.direction.z},
                                                      {"Edir", s.eye_lux},
                                                      {"zone", double(s.zone)},
                                                      {"DGPshare", share}};
    for (const auto& [name, value] : numbers) add(line, name, number_cell(value, is_aligned(o) ? 5 : 8));
    if (o.outlines) add(line, "outline", {outline});
}

// A line for each source, or for the metrics.
std::vector<Line> lines_of(const Options& o, const Heading& heading, const RunState& run, const Row& row) {
    const std::vector<GlareSource>& sources = row.measurement.sources;
    const std::vector<double> shares = dgp_shares(terms_of(sources), o.settings.constants);
    std::vector<Line> out(o.list_sources ? sources.size() : 1, start_of(o, heading, row));
    for (size_t k = 0; k < out.size(); ++k) {
        if (!o.list_sources) add_columns(o, run.plan.columns, row, out[k]);
        else
            add_source(o, sources[k], k + 1, shares[k],
                       o.outlines ? source_outline(row.measurement, run.reading.geometry(), sources[k]) : "", out[k]);
        if (heading.paths) add(out[k], paths_column, text_cell(row.paths.empty() ? "-" : row.paths));
        if (heading.hours) add(out[k], hour_column, text_cell(row.hour.empty() ? "-" : row.hour));
    }
    return out;
}

}  // namespace

RowText text_of(const Options& o, Heading heading, const RunState& run, const Row& row) {
    if (o.mode == OutputMode::evalglare)
        return {heading, "", evalglare::lines(row.measurement, o.evalglare, run.reading)};
    if (heading.names.empty())
        heading.views = !row.view.empty(), heading.skies = !row.sky.empty(), heading.states = !row.state.empty(),
        heading.edits = row.edit.has_value();
    heading.paths = heading.paths || !row.paths.empty();
    heading.hours = heading.hours || !row.hour.empty();
    const std::vector<Line> lines = lines_of(o, heading, run, row);
    Line first = lines.empty() ? start_of(o, heading, row) : lines[0];
    if (lines.empty()) add_source(o, {}, 0, 0, "", first);
    RowText out{heading, first.names != heading.names ? header_line(first.names, o.format) : "", ""};
    out.heading.names = first.names;
    for (const Line& line : lines) out.lines += table_line(line, o.format);
    return out;
}
