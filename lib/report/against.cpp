// SPDX-License-Identifier: BSD-3-Clause
// See against.h.
#include "report/against.h"

#include <algorithm>
#include <cmath>
#include <fstream>

namespace report {
namespace {

constexpr size_t most_edits = 300;  // whose looks are kept: some 30 MB

uncertainty::Estimate unknown() { return {std::nan(""), std::nan(""), 0, 0, false, 0}; }

int64_t base_of(const Edits& edits, std::string which) {
    if (which != "previous" && which != "first") std::ifstream(which) >> which;
    if (which == "first") return edits.earlier.empty() ? -1 : edits.earlier.begin()->first;
    const bool number = !which.empty() && which.size() < 18 && which.find_first_not_of("0123456789") == which.npos;
    return number ? std::stoll(which) : edits.previous;
}

void compare(Edits& edits, const Edits::Look& look) {
    const auto base = edits.earlier.find(edits.base);
    if (base == edits.earlier.end()) return;
    for (const Edits::Look& before : base->second) {
        if (before.replicates.count() != look.replicates.count()) continue;
        std::vector<size_t> mine, its;
        std::vector<uncertainty::Quantity> compared;
        for (size_t c = 0; c < look.keys.size(); ++c) {
            const auto found = std::find(before.keys.begin(), before.keys.end(), look.keys[c]);
            if (found == before.keys.end()) continue;
            mine.push_back(c), its.push_back(size_t(found - before.keys.begin()));
            compared.push_back(look.quantities[c]);
        }
        const auto of =
            uncertainty::difference(select(before.replicates, its), select(look.replicates, mine), compared);
        edits.differences.assign(look.keys.size(), unknown());
        for (size_t k = 0; k < mine.size(); ++k) edits.differences[mine[k]] = of[k];
    }
}

}  // namespace

uncertainty::Estimate Edits::difference(size_t column) const {
    return column < differences.size() ? differences[column] : unknown();
}

Edits begin(Edits edits, const std::string& which, int64_t edit) {
    if (edit != edits.edit) {
        if (!edits.own.empty()) edits.earlier[edits.previous = edits.edit] = std::move(edits.own);
        if (edits.earlier.size() > most_edits) edits.earlier.erase(std::next(edits.earlier.begin()));
        edits.edit = edit, edits.base = -1;
        edits.own.clear(), edits.differences.clear();
    }
    const int64_t base = base_of(edits, which);
    if (base == edits.base) return edits;
    edits.base = base;
    edits.differences.clear();
    for (const Edits::Look& look : edits.own) compare(edits, look);
    return edits;
}

Edits add(Edits edits, Edits::Look look) {
    if (!edits.own.empty() && look.replicates.count() <= edits.own.back().replicates.count())
        edits.own.clear(), edits.differences.clear();
    compare(edits, look);
    edits.own.push_back(std::move(look));
    return edits;
}

}  // namespace report
