// SPDX-License-Identifier: BSD-3-Clause
// See row.h.
#include "row.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "drawing.h"

using namespace glare;
using namespace report;

namespace {

bool is_plain(const Options& o) { return o.mode != OutputMode::accelerad; }

bool has_interval(const Options& o, const Column& c) { return o.ci && !c.words; }
bool has_difference(const Options& o, const Column& c) { return o.against != EarlierEdit::none && !c.words; }

double printed_value(const Column& c, size_t k, const RowOfPicture& row) {
    const double unbiased = c.printed_unbiased ? row.estimates->estimate(k).value : std::nan("");
    const bool plain = !c.printed_unbiased || (c.of_filled && std::isnan(unbiased));
    return plain ? c.value(row.measurement) : unbiased;
}

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

// A value and the interval around `middle`, which may be another one.
void add_numbers(const Options& o, double value, double middle, const uncertainty::Interval& off,
                 std::vector<Cell>& cells) {
    if (is_aligned(o)) cells.push_back({with_error(std::isnan(middle) ? value : middle, off.half_width()), true});
    else add_numbers({value, middle + off.low, middle + off.high}, cells);
}

// The interval lies around the value without bias, which the column itself may show or not.  Between looks that is
// the last look's value with the interval it had; a value without bias is of the frame itself, and narrows as they
// grow.
void add_with_interval(const Options& o, const Column& c, size_t k, double value, const RowOfPicture& row,
                       std::vector<Cell>& cells) {
    const uncertainty::Estimate& e = row.estimates->estimate(k);
    const uncertainty::Interval off = e.around(1 - *o.ci, c.has_bias() ? e.frames : row.frame);
    add_numbers(o, value, c.has_bias() ? e.value : value, off, cells);
}

std::string heavy_tailed(const std::vector<Column>& columns, const ColumnEstimates& estimates) {
    std::string out;
    for (size_t k = 0; k < columns.size(); ++k)
        if (columns[k].printed && estimates.estimate(k).unreliable) out += (out.empty() ? "" : " ") + columns[k].name;
    return out.empty() ? "-" : out;
}

size_t longest(const std::vector<std::string>& texts) {
    size_t out = 0;
    for (const std::string& t : texts) out = std::max(out, t.size());
    return out;
}

}  // namespace

NamedPictures named_pictures(const image::Header& first) {
    return {!first.view_name.empty(), !first.sky_name.empty(), first.edit.has_value()};
}

std::vector<std::string> start_names(const Options& o, const NamedPictures& named) {
    std::vector<std::string> out;
    if (!is_plain(o)) out = {"Time", "Frame"};
    else if (!o.files.empty()) out = {is_aligned(o) ? fmt::format("{:<{}}", "file", longest(o.files)) : "file"};
    else out = {"frame", "seconds"};
    if (named.view) out.push_back("view");
    if (named.sky) out.push_back("sky");
    if (named.edit) out.push_back("edit");
    return out;
}

std::vector<Cell> start_cells(const Options& o, const NamedPictures& named, const image::Header& header,
                              const std::string& file, int64_t frame, double seconds) {
    const Cell frame_cell = number_cell(double(frame), 15);
    const Cell seconds_cell = number_cell(o.files.empty() ? std::round(seconds * 1000) / 1000 : 0, 9);
    std::vector<Cell> out = {frame_cell, seconds_cell};
    if (!is_plain(o)) out = {seconds_cell, frame_cell};
    else if (!o.files.empty()) out = {text_cell(file)};
    const auto name = [](const std::string& text) { return text_cell(text.empty() ? "-" : text); };
    if (named.view) out.push_back(name(header.view_name));
    if (named.sky) out.push_back(name(header.sky_name));
    if (named.edit) out.push_back(number_cell(double(header.edit.value_or(0))));
    return out;
}

std::vector<std::string> row_names(const Options& o, const std::vector<Column>& columns) {
    std::vector<std::string> out;
    for (const Column& c : columns) {
        if (!c.printed) continue;
        if (has_interval(o, c)) add_names(o, c.name, out);
        else out.push_back(c.words && is_aligned(o) ? fmt::format("{:>13}", c.name) : c.name);
        if (has_difference(o, c)) add_names(o, c.name + ".d", out);
    }
    if (o.go_on) out.push_back("settled");
    if (o.ci) out.push_back(is_aligned(o) ? "tails    " : "tails");
    return out;
}

std::vector<Cell> row_cells(const Options& o, const std::vector<Column>& columns, const RowOfPicture& row) {
    std::vector<Cell> out;
    for (size_t k = 0; k < columns.size(); ++k) {
        const Column& c = columns[k];
        if (!c.printed) continue;
        const double value = printed_value(c, k, row);
        if (has_interval(o, c)) add_with_interval(o, c, k, value, row, out);
        else if (c.words) out.push_back({c.words[int(value)], is_aligned(o)});
        else out.push_back(number_cell(value, is_aligned(o) ? 5 : 8));
        if (!has_difference(o, c)) continue;
        const uncertainty::Estimate d = row.against.difference(k);
        const uncertainty::Interval off = d.around(1 - o.ci.value_or(.95), d.frames);
        add_numbers(o, d.value, d.value, off, out);
    }
    if (o.go_on) out.push_back(number_cell(row.settled));
    if (o.ci) out.push_back(text_cell(heavy_tailed(columns, *row.estimates)));
    return out;
}

std::vector<std::string> source_names(const Options& o) {
    std::vector<std::string> names = {"source", "pixels", "x",    "y",    "omega", "L",    "P",
                                      "sigma",  "xdir",   "ydir", "zdir", "Edir",  "zone", "DGPshare"};
    if (o.outlines) names.push_back("outline");
    return names;
}

std::vector<std::vector<Cell>> source_rows(const Options& o, const Measurement& m, const Geometry& geometry) {
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
