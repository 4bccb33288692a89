// SPDX-License-Identifier: BSD-3-Clause
// See rows.h.
#include "live/rows.h"

#include <algorithm>
#include <cstdlib>

#include "base/split.h"

namespace live {

namespace {

double number_in(const std::string& cell) {
    char* end = nullptr;
    const double value = std::strtod(cell.c_str(), &end);
    return cell.empty() || *end ? std::nan("") : value;
}

// {"name": value, ...}, as vcmetrics writes it: no objects within.
Row read_object(const std::string& line) {
    Row row;
    const auto end_of_text = [&](size_t at) {
        for (++at; at < line.size() && line[at] != '"'; ++at) at += line[at] == '\\';
        return at;
    };
    for (size_t at = 1; (at = line.find('"', at)) != std::string::npos;) {
        const size_t end = end_of_text(at), value = line.find_first_not_of(": ", end + 1);
        if (value == std::string::npos) break;
        const size_t after = line.find_first_of(",}", line[value] == '"' ? end_of_text(value) : value);
        const std::string cell = line.substr(value, after == std::string::npos ? after : after - value);
        row.cells.emplace_back(line.substr(at + 1, end - at - 1), number_in(cell));
        at = after;
    }
    return row;
}

}  // namespace

std::optional<Row> read_row(std::vector<std::string>& names, const std::string& line) {
    if (!line.empty() && line[0] == '{') return read_object(line);
    const std::vector<std::string> cells = base::split_list(line, '\t');
    if (std::find(cells.begin(), cells.end(), "frame") != cells.end()) {
        names = cells;
        return {};
    }
    if (cells.size() != names.size()) return {};
    Row row;
    for (size_t c = 0; c < cells.size(); ++c) row.cells.emplace_back(names[c], number_in(cells[c]));
    return row;
}

std::string with_edit(const std::vector<std::string>& names, const std::string& line, int64_t edit) {
    if (!line.empty() && line[0] == '{') {
        const size_t at = line.find("\"edit\": "), from = at + 8;
        return at == std::string::npos ? line
                                       : line.substr(0, from) + std::to_string(edit) +
                                             line.substr(std::min(line.size(), line.find_first_of(",}", from)));
    }
    std::string out;
    const std::vector<std::string> cells = base::split_list(line, '\t');
    for (size_t c = 0; c < cells.size(); ++c)
        out += (c ? "\t" : "") + (c < names.size() && names[c] == "edit" ? std::to_string(edit) : cells[c]);
    return out;
}

}  // namespace live
