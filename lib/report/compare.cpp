// SPDX-License-Identifier: BSD-3-Clause
// See compare.h.
#include "report/compare.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include "base/error.h"
#include "glare/columns.h"

namespace report {
namespace {

// "TAL" means every region's, as for -metrics.
bool is_part(const std::string& metric, const std::string& wanted) {
    const size_t dot = metric.rfind('.');
    return dot != std::string::npos && metric.substr(dot + 1) == wanted;
}

// Empty: rows have no names, or not one each.
std::unordered_map<std::string, size_t> rows_by_name(const NumberTable& t) {
    std::unordered_map<std::string, size_t> out;
    for (size_t r = 0; r < t.row_names.size() && !t.labels.empty(); ++r) out.emplace(t.row_names[r], r);
    if (out.size() != t.rows.size()) out.clear();
    return out;
}

void require_row(bool there, const NumberTable& table, const NumberTable& of, const std::string& name) {
    if (!there) base::fail(table.name, "has no row for " + of.labels[0] + " " + name + " of " + of.name);
}

}  // namespace

Tolerance tolerance_for(const std::string& metric, const std::vector<Tolerance>& rules) {
    const glare::DefaultTolerance own = glare::tolerance_of(metric);
    Tolerance t{metric, own.amount, own.share};
    for (const std::string& name : {std::string("all"), metric})
        for (const Tolerance& r : rules)
            if (r.metric == name) t.amount = r.amount, t.share = r.share;
    return t;
}

bool within(const Tolerance& tolerance, double first, double second) {
    constexpr double printed = 1e-6;  // six decimals of a recorded line carry an error of half a unit
    if (first == second || (std::isnan(first) && std::isnan(second))) return true;
    return std::fabs(first - second) <= tolerance.of(std::max(std::fabs(first), std::fabs(second))) + printed;
}

NumberTable only(const NumberTable& table, const std::vector<std::string>& metrics, const std::string& whose) {
    std::vector<size_t> columns;
    for (const std::string& wanted : metrics) {
        const size_t before = columns.size();
        const bool whole = std::find(table.names.begin(), table.names.end(), wanted) != table.names.end();
        for (size_t k = 0; k < table.names.size(); ++k)
            if (whole ? table.names[k] == wanted : is_part(table.names[k], wanted)) columns.push_back(k);
        if (columns.size() == before) base::fail(table.name, "lacks the metric " + wanted + " of " + whose);
    }
    NumberTable kept = table;
    const auto select = [&](const auto& all, auto& some) {
        some.clear();
        for (size_t k : columns) some.push_back(all[k]);
    };
    select(table.names, kept.names);
    for (size_t r = 0; r < table.rows.size(); ++r) select(table.rows[r], kept.rows[r]);
    return kept;
}

std::vector<size_t> pair_rows(const NumberTable& first, const NumberTable& second) {
    std::vector<size_t> partner(first.rows.size());
    std::iota(partner.begin(), partner.end(), 0);
    const auto mine = rows_by_name(first), theirs = rows_by_name(second);
    const bool single = first.rows.size() == 1 && second.rows.size() == 1;
    if (!single && first.labels == second.labels && !mine.empty() && !theirs.empty()) {
        for (const std::string& name : second.row_names) require_row(mine.count(name), first, second, name);
        for (size_t r = 0; r < partner.size(); ++r) {
            require_row(theirs.count(first.row_names[r]), second, first, first.row_names[r]);
            partner[r] = theirs.at(first.row_names[r]);
        }
    } else if (first.rows.size() != second.rows.size()) {
        const NumberTable& shorter = first.rows.size() < second.rows.size() ? first : second;
        base::fail(shorter.name, "has only " + std::to_string(shorter.rows.size()) + " rows of " +
                                     std::to_string(std::max(first.rows.size(), second.rows.size())));
    }
    return partner;
}

}  // namespace report
