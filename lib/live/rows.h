// SPDX-License-Identifier: BSD-3-Clause
// A line of vcmetrics as numbers by name: of a table, whose names stand in a line of their own, or a JSON object.
#pragma once
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace live {

struct Row {
    std::vector<std::pair<std::string, double>> cells;  // NaN: no number
    double of(const std::string& name) const {
        for (const auto& [known, value] : cells)
            if (known == name) return value;
        return std::nan("");
    }
    int64_t edit() const { return integer("edit", 0); }
    int64_t frame() const { return integer("frame", -1); }

private:
    int64_t integer(const char* name, int64_t none) const { return std::isfinite(of(name)) ? int64_t(of(name)) : none; }
};

// names: of the columns so far, and those that this line gives.  Nothing: the line is no row.
std::optional<Row> read_row(std::vector<std::string>& names, const std::string& line);
// The line with another number of the edit.
std::string with_edit(const std::vector<std::string>& names, const std::string& line, int64_t edit);

}  // namespace live
