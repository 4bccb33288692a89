// SPDX-License-Identifier: BSD-3-Clause
// See against.h.
#include "report/against.h"

#include <algorithm>
#include <cmath>

namespace report {
namespace {

uncertainty::Estimate unknown() { return {std::nan(""), std::nan(""), 0, 0, false, 0}; }

}  // namespace

uncertainty::Estimate Edits::difference(int64_t of_edit, size_t column) const {
    return of_edit == edit && column < differences.size() ? differences[column] : unknown();
}

Edits add(Edits edits, EarlierEdit which, int64_t edit, Edits::Look look,
          const std::vector<uncertainty::Quantity>& quantities) {
    const int64_t n = look.replicates.count();
    const bool other = edit != edits.edit;
    if (other && !edits.own.empty() && (which == EarlierEdit::previous || edits.earlier.empty()))
        edits.earlier = std::move(edits.own);
    if (other || (!edits.own.empty() && n <= edits.own.back().replicates.count()))
        edits.own.clear(), edits.differences.clear();
    edits.edit = edit;
    for (const Edits::Look& before : edits.earlier) {
        if (before.replicates.count() != n) continue;
        std::vector<size_t> mine, its;
        std::vector<uncertainty::Quantity> compared;
        for (size_t c = 0; c < look.keys.size(); ++c) {
            const auto found = std::find(before.keys.begin(), before.keys.end(), look.keys[c]);
            if (found == before.keys.end()) continue;
            mine.push_back(c), its.push_back(size_t(found - before.keys.begin()));
            compared.push_back(quantities[c]);
        }
        const auto of =
            uncertainty::difference(select(before.replicates, its), select(look.replicates, mine), compared);
        edits.differences.assign(look.keys.size(), unknown());
        for (size_t k = 0; k < mine.size(); ++k) edits.differences[mine[k]] = of[k];
    }
    edits.own.push_back(std::move(look));
    return edits;
}

}  // namespace report
