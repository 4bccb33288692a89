// SPDX-License-Identifier: BSD-3-Clause
// See vectors.h.
#include "parity/vectors.h"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "base/error.h"

namespace parity {
namespace {

std::vector<std::string> split(const std::string& line) {
    std::vector<std::string> cells(1);
    for (char c : line) {
        if (c == '\t') cells.emplace_back();
        else cells.back() += c;
    }
    return cells;
}

std::vector<double> numbers(const std::string& text) {
    std::istringstream in(text);
    std::vector<double> values;
    for (double v; in >> v;) values.push_back(v);
    return values;
}

std::vector<std::vector<std::string>> rows_of(const std::string& path) {
    std::ifstream in(path);
    if (!in) base::fail_system(path, "cannot be read");
    std::vector<std::vector<std::string>> rows;
    for (std::string line; std::getline(in, line);)
        if (!line.empty() && line[0] != '#') rows.push_back(split(line));
    return rows;
}

}  // namespace

std::vector<Row> read_rays(const std::string& path) {
    std::vector<Row> rays;
    for (const auto& cells : rows_of(path)) {
        if (cells.size() < 6 || (cells[1] != "rtrace" && cells[1].rfind("rtrace-mean", 0) != 0)) continue;
        Row row{cells[0], cells[1], cells[2], cells[3], numbers(cells[4]), numbers(cells[5]), {}, {}};
        const std::string note = cells.size() > 6 ? cells[6] : "";
        const size_t at = note.find("standard error ");
        if (at != std::string::npos) {
            const std::vector<double> error = numbers(note.substr(at + 15));
            for (size_t c = 0; c < error.size() && c < 3; ++c) row.error[c] = error[c];
        }
        if (note.rfind("exact (", 0) == 0) row.exact = std::atof(note.c_str() + note.find(')') + 1);
        if (row.input.size() == 6) rays.push_back(row);
    }
    return rays;
}

std::vector<Exception> read_exceptions(const std::string& path) {
    std::vector<Exception> list;
    for (const auto& cells : rows_of(path)) {
        if (cells.size() != 2) base::fail(path, "a line is an id, a tab and a reason");
        list.push_back({cells[0], cells[1]});
    }
    return list;
}

}  // namespace parity
