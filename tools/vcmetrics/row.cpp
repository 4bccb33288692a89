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
void add_names(const Options& o, const std::string& name, std::vector<std::string>& out) {
    if (is_aligned(o)) out.push_back(fmt::format("{:>{}}", name, width_with_error));
    else out.insert(out.end(), {name, name + ".lo", name + ".hi"});
}

void add_numbers(std::initializer_list<double> values, std::vector<Cell>& cells, int digits = 8) {
    for (const double v : values) cells.push_back(number_cell(v, digits));
}

void add_with_interval(const Options& o, const Number& n, std::vector<Cell>& cells) {
    if (is_aligned(o))
        cells.push_back({with_error(std::isnan(n.middle) ? n.value : n.middle, n.off.half_width()), true});
    else add_numbers({n.value, n.middle + n.off.low, n.middle + n.off.high}, cells);
}

size_t longest(const std::vector<std::string>& texts) {
    size_t out = 0;
    for (const std::string& t : texts) out = std::max(out, t.size());
    return out;
}

std::vector<std::string> start_names(const Options& o, const Heading& heading) {
    std::vector<std::string> out;
    if (!is_plain(o)) out = {"Time", "Frame"};
    else if (!o.files.empty()) out = {is_aligned(o) ? fmt::format("{:<{}}", "file", longest(o.files)) : "file"};
    else out = {"frame", "seconds"};
    if (heading.views) out.push_back("view");
    if (heading.skies) out.push_back("sky");
    if (heading.edits) out.push_back("edit");
    return out;
}

std::vector<Cell> start_cells(const Options& o, const Heading& heading, const Row& row) {
    const Cell frame_cell = number_cell(double(row.frame), 15);
    const Cell seconds_cell = number_cell(o.files.empty() ? std::round(row.seconds * 1000) / 1000 : 0, 9);
    std::vector<Cell> out = {frame_cell, seconds_cell};
    if (!is_plain(o)) out = {seconds_cell, frame_cell};
    else if (!o.files.empty()) out = {text_cell(row.file)};
    const auto name = [](const std::string& text) { return text_cell(text.empty() ? "-" : text); };
    if (heading.views) out.push_back(name(row.view));
    if (heading.skies) out.push_back(name(row.sky));
    if (heading.edits) out.push_back(number_cell(double(row.edit.value_or(0))));
    return out;
}

std::vector<std::string> column_names(const Options& o, const std::vector<Column>& columns) {
    std::vector<std::string> out;
    for (const Column& c : columns) {
        if (!c.printed) continue;
        if (has_interval(o, c)) add_names(o, c.name, out);
        else out.push_back(c.words && is_aligned(o) ? fmt::format("{:>13}", c.name) : c.name);
        if (has_difference(o, c)) add_names(o, c.name + ".d", out);
    }
    if (o.go_on) out.push_back("settled");
    if (o.ci) out.push_back(is_aligned(o) ? "tails    " : "tails");
    if (o.ci && !is_aligned(o)) out.push_back(errors_column);
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

std::vector<Cell> column_cells(const Options& o, const std::vector<Column>& columns, const Row& row) {
    std::vector<Cell> out;
    for (size_t k = 0; k < columns.size(); ++k) {
        const Column& c = columns[k];
        const Number& n = row.numbers[k];
        if (!c.printed) continue;
        if (has_interval(o, c)) add_with_interval(o, n, out);
        else if (c.words && !std::isnan(n.value)) out.push_back({c.words[int(n.value)], is_aligned(o)});
        else out.push_back(number_cell(n.value, is_aligned(o) ? 5 : 8));
        if (has_difference(o, c)) add_with_interval(o, row.differences[k], out);
    }
    if (o.go_on) out.push_back(number_cell(row.settled));
    if (o.ci) out.push_back(text_cell(row.heavy_tailed.empty() ? "-" : row.heavy_tailed));
    if (o.ci && !is_aligned(o)) out.push_back(text_cell(errors_cell(o, columns, row)));
    return out;
}

std::vector<std::string> source_names(const Options& o) {
    std::vector<std::string> names = {"source", "pixels", "x",    "y",    "omega", "L",    "P",
                                      "sigma",  "xdir",   "ydir", "zdir", "Edir",  "zone", "DGPshare"};
    if (o.outlines) names.push_back("outline");
    return names;
}

// A line for each source.
std::vector<std::vector<Cell>> source_cells(const Options& o, const Measurement& m, const Geometry& geometry) {
    const std::vector<double> shares = dgp_shares(terms_of(m.sources), o.settings.constants);
    std::vector<std::vector<Cell>> out;
    for (size_t k = 0; k < m.sources.size(); ++k) {
        const GlareSource& s = m.sources[k];
        out.emplace_back();
        add_numbers({double(k + 1), s.pixels, s.x, s.y, s.omega, s.lum, s.P, s.sigma_deg, s.direction.x, s.direction.y,
                     s.direction.z, s.eye_lux, double(s.zone), shares[k]},
                    out.back(), is_aligned(o) ? 5 : 8);
        if (o.outlines) out.back().push_back({source_outline(m, geometry, s)});
    }
    return out;
}

}  // namespace

RowText text_of(const Options& o, Heading heading, const RunState& run, const Row& row) {
    if (o.mode == OutputMode::evalglare)
        return {heading, "", evalglare::lines(row.measurement, o.evalglare, run.reading)};
    if (heading.names.empty())
        heading.views = !row.view.empty(), heading.skies = !row.sky.empty(), heading.edits = row.edit.has_value();
    std::vector<std::string> names = start_names(o, heading);
    const std::vector<std::string> more = o.list_sources ? source_names(o) : column_names(o, run.plan.columns);
    names.insert(names.end(), more.begin(), more.end());
    heading.paths = heading.paths || !row.paths.empty();
    if (heading.paths) names.push_back(paths_column);
    RowText out{heading, names != heading.names ? header_line(names, o.format) : "", ""};
    out.heading.names = names;
    const std::vector<std::vector<Cell>> lines =
        o.list_sources ? source_cells(o, row.measurement, run.reading.geometry())
                       : std::vector<std::vector<Cell>>{column_cells(o, run.plan.columns, row)};
    for (const std::vector<Cell>& line : lines) {
        std::vector<Cell> cells = start_cells(o, heading, row);
        cells.insert(cells.end(), line.begin(), line.end());
        if (heading.paths) cells.push_back(text_cell(row.paths.empty() ? "-" : row.paths));
        out.lines += table_line(names, cells, o.format);
    }
    return out;
}
