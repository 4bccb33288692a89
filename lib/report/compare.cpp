// SPDX-License-Identifier: BSD-3-Clause
// Pairs the rows and columns of two tables, and finds those that differ by more than the tolerance (compare.h).
#include "report/compare.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <unordered_map>
#include "base/error.h"
#include "base/edit_distance.h"

namespace report {
namespace {

// Relative tolerances of the metrics that are not computed from one sum: the spread between builds of evalglare itself.
const std::map<std::string, Tolerance> defaults = {{"DGP", {"DGP", 2e-5, 0}},
                                                   {"VCP", {"VCP", 0, 0.02}},
                                                   {"DGR", {"DGR", 0, 0.02}},
                                                   {"Lveil", {"Lveil", 0, 0.05}},
                                                   {"LveilCIE", {"LveilCIE", 0, 0.05}},
                                                   {"n_sources", {"n_sources", 0, 0}},
                                                   {"not_finite", {"not_finite", 0, 0}},
                                                   {"negative", {"negative", 0, 0}}};

bool rows_have_names(const NumberTable& t) {
    const std::set<std::string> different(t.row_names.begin(), t.row_names.end());
    return !t.labels.empty() && different.size() == t.rows.size();
}

// "TAL" means every region's, as for -metrics.
bool means(const std::string& wanted, const std::string& metric) {
    return metric == wanted || (metric.size() > wanted.size() && metric.compare(metric.size() - wanted.size() - 1,
                                                                                std::string::npos, "." + wanted) == 0);
}

size_t column(const NumberTable& t, const std::string& metric) {
    return size_t(std::find(t.names.begin(), t.names.end(), metric) - t.names.begin());
}

// The row of `second` for each row of `first`.
std::vector<size_t> pair_rows(const NumberTable& first, const NumberTable& second) {
    std::vector<size_t> partner;
    const bool single = first.rows.size() == 1 && second.rows.size() == 1;
    if (!single && first.labels == second.labels && rows_have_names(first) && rows_have_names(second)) {
        for (const auto& [one, other] : {std::pair(&second, &first), std::pair(&first, &second)}) {
            std::unordered_map<std::string, size_t> row_of;
            for (size_t r = 0; r < other->rows.size(); ++r) row_of[other->row_names[r]] = r;
            partner.clear();
            for (const std::string& name : one->row_names) {
                const auto found = row_of.find(name);
                if (found == row_of.end())
                    base::fail(other->name, "has no row for " + one->labels[0] + " " + name + " of " + one->name);
                partner.push_back(found->second);
            }
        }
        return partner;
    }
    if (first.rows.size() != second.rows.size()) {
        const NumberTable& shorter = first.rows.size() < second.rows.size() ? first : second;
        base::fail(shorter.name, "has only " + std::to_string(shorter.rows.size()) + " rows of " +
                                     std::to_string(std::max(first.rows.size(), second.rows.size())));
    }
    for (size_t r = 0; r < first.rows.size(); ++r) partner.push_back(r);
    return partner;
}

}  // namespace

Tolerance tolerance_for(const std::string& metric, const std::vector<Tolerance>& rules) {
    Tolerance t{metric, 0, 1e-4};
    const auto known = defaults.find(metric);
    if (known != defaults.end()) t = known->second;
    for (const char* name : {"all", metric.c_str()})
        for (const Tolerance& r : rules)
            if (r.metric == name) t.amount = r.amount, t.share = r.share;
    return t;
}

void require_known(const std::vector<Tolerance>& rules, const std::vector<std::string>& names) {
    for (const Tolerance& rule : rules) {
        if (rule.metric == "all" || std::find(names.begin(), names.end(), rule.metric) != names.end()) continue;
        base::fail("-tolerance",
                   "there is no metric \"" + rule.metric + "\" here" + base::question(rule.metric, names));
    }
}

NumberTable only(const NumberTable& table, const std::vector<std::string>& metrics) {
    NumberTable kept = table;
    kept.names.clear();
    std::vector<size_t> columns;
    for (const std::string& wanted : metrics) {
        const size_t before = columns.size();
        for (size_t k = 0; k < table.names.size(); ++k)
            if (means(wanted, table.names[k])) columns.push_back(k);
        if (columns.size() == before) base::fail(table.name, "lacks the metric " + wanted + " of -metrics");
    }
    for (size_t k : columns) kept.names.push_back(table.names[k]);
    for (size_t r = 0; r < table.rows.size(); ++r) {
        kept.rows[r].clear();
        for (size_t k : columns) kept.rows[r].push_back(table.rows[r][k]);
    }
    return kept;
}

std::vector<Difference> compare_tables(const NumberTable& first, const NumberTable& second,
                                       const std::vector<Tolerance>& rules) {
    for (const auto& [one, other] : {std::pair(&first, &second), std::pair(&second, &first)})
        for (const std::string& name : one->names)
            if (column(*other, name) == other->names.size())
                base::fail(other->name, "lacks the metric " + name + " of " + one->name);
    const std::vector<size_t> partner = pair_rows(first, second);
    std::vector<Difference> out;
    for (size_t r = 0; r < first.rows.size(); ++r)
        for (size_t k = 0; k < first.names.size(); ++k) {
            const double a = first.rows[r][k], b = second.rows[partner[r]][column(second, first.names[k])];
            const Tolerance t = tolerance_for(first.names[k], rules);
            const double limit = t.of(std::max(std::fabs(a), std::fabs(b)));
            const bool same = a == b || (std::isnan(a) && std::isnan(b));
            const bool named = first.row_names.size() > r && !first.row_names[r].empty();
            // 6 decimals of a recorded line carry an error of half a unit
            out.push_back({named ? first.row_names[r] : std::to_string(r + 1), first.names[k], a, b, t,
                           same || std::fabs(a - b) <= limit + 1e-6});
        }
    return out;
}

}  // namespace report
