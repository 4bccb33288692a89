// SPDX-License-Identifier: BSD-3-Clause
// Numbers as text in the three formats (table.h).
#include "report/table.h"
#include <fmt/format.h>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include "base/printable.h"

namespace report {
namespace {

std::string quoted_csv(const std::string& s) {
    if (s.find_first_of(",\"\n") == std::string::npos) return base::printable(s);
    std::string out = "\"";
    for (char c : base::printable(s)) out += c == '"' ? std::string("\"\"") : std::string(1, c);
    return out + "\"";
}

constexpr size_t narrowest = 9;  // columns on a terminal

std::string aligned(const std::string& text, size_t width, bool right) {
    const std::string blanks(std::max(width, narrowest) - std::min(text.size(), std::max(width, narrowest)), ' ');
    return right ? blanks + text : text + blanks;
}

std::string plain_tsv(std::string s) {
    for (char& c : s)
        if (c == '\t' || c == '\n') c = ' ';
    return base::printable(s);
}

}  // namespace

Cell number_cell(double value, int digits) {
    char text[40];
    std::snprintf(text, sizeof text, "%.*g", digits, value);
    if (std::isnan(value)) return {"nan", true};
    return {text, true};
}

Cell text_cell(const std::string& text) { return {text, false}; }

std::string rounded(double value, double half_width) {
    const bool known = half_width > 0 && std::isfinite(half_width);
    const double size = known ? half_width : std::fabs(value);
    const int power = size > 0 && std::isfinite(size) ? int(std::floor(std::log10(size))) - (known ? 1 : 3) : 0;
    const double unit = power > 0 ? std::pow(10., power) : 0;  // of the last digit
    return fmt::format("{:.{}f}", unit > 0 ? std::round(value / unit) * unit : value, std::max(-power, 0));
}

std::string with_error(double value, double half_width) {
    if (!std::isfinite(half_width)) return number_cell(value, 4).text;
    if (!(half_width > 0)) return number_cell(value, 6).text + " +- 0";
    return rounded(value, half_width) + " +- " + rounded(half_width, half_width);
}

void add(Line& line, const std::string& name, const Cell& cell) {
    line.names.push_back(name);
    line.cells.push_back(cell);
}

void add_bounds(Line& line, const std::string& name, double value, double low, double high) {
    add(line, name, value), add(line, name + ".lo", low), add(line, name + ".hi", high);
}

std::string header_line(const std::vector<std::string>& names, TableFormat format) {
    if (format == TableFormat::jsonl) return "";
    std::string out;
    for (const std::string& n : names)
        if (format == TableFormat::aligned) out += (out.empty() ? "" : "  ") + aligned(base::printable(n), 0, true);
        else
            out += (out.empty()                  ? ""
                    : format == TableFormat::tsv ? "\t"
                                                 : ",") +
                   (format == TableFormat::tsv ? plain_tsv(n) : quoted_csv(n));
    return out + "\n";
}

std::string table_line(const Line& line, TableFormat format) {
    std::string out;
    for (size_t k = 0; k < line.cells.size(); ++k) {
        const Cell& c = line.cells[k];
        if (format == TableFormat::jsonl) {
            const bool finite = c.text.find_first_of("ni") == std::string::npos;
            out += (k ? ", " : "{") + base::quoted_json(line.names[k]) + ": " +
                   (!c.number ? base::quoted_json(c.text)
                    : finite  ? c.text
                              : "null");
        } else if (format == TableFormat::aligned) {
            out += (k ? "  " : "") + aligned(plain_tsv(c.text), line.names[k].size(), c.number);
        } else if (format == TableFormat::csv) {
            out += (k ? "," : "") + (c.number ? c.text : quoted_csv(c.text));
        } else {
            out += (k ? "\t" : "") + plain_tsv(c.text);
        }
    }
    return out + (format == TableFormat::jsonl ? "}\n" : "\n");
}

std::string table(const std::vector<Line>& lines, TableFormat format) {
    std::string out = lines.empty() ? "" : header_line(lines[0].names, format);
    for (const Line& line : lines) out += table_line(line, format);
    return out;
}

}  // namespace report
