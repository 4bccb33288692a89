// SPDX-License-Identifier: BSD-3-Clause
// See against.h.
#include "report/against.h"

#include <algorithm>
#include <cmath>

namespace report {

void Against::begin(int64_t edit) {
    if (edit == edit_) return;
    edit_ = edit;
    if (!own_.empty() && (which_ == EarlierEdit::previous || earlier_.empty())) earlier_ = std::move(own_);
    own_.clear(), differences_.clear();
}

void Against::look(const uncertainty::Replicates& replicates, const std::vector<std::string>& keys,
                   const std::vector<uncertainty::Quantity>& quantities) {
    const int64_t n = replicates.count();
    if (!own_.empty() && n <= own_.back().replicates.count()) own_.clear(), differences_.clear();
    own_.push_back({replicates, keys});
    for (const Look& before : earlier_) {
        if (before.replicates.count() != n) continue;
        std::vector<size_t> mine, its;
        std::vector<uncertainty::Quantity> compared;
        for (size_t c = 0; c < keys.size(); ++c) {
            const auto found = std::find(before.keys.begin(), before.keys.end(), keys[c]);
            if (found == before.keys.end()) continue;
            mine.push_back(c), its.push_back(size_t(found - before.keys.begin()));
            compared.push_back(quantities[c]);
        }
        const auto of = uncertainty::difference(select(before.replicates, its), select(replicates, mine), compared);
        differences_.assign(keys.size(), {std::nan(""), std::nan("")});
        for (size_t k = 0; k < mine.size(); ++k) differences_[mine[k]] = of[k];
    }
}

uncertainty::Estimate Against::difference(size_t column) const {
    return column < differences_.size() ? differences_[column]
                                        : uncertainty::Estimate{std::nan(""), std::nan(""), 0, 0, false, 0};
}

}  // namespace report
