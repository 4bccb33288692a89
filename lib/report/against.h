// SPDX-License-Identifier: BSD-3-Clause
// In a live stream: the difference of columns between the picture of one edit and that of an earlier one, at the same
// number of frames (uncertainty/difference.h).  Of an edit the replicates' values of each look are kept, not pictures.
#pragma once
#include <string>
#include <vector>
#include "uncertainty/difference.h"

namespace report {

enum class EarlierEdit { none, previous, first };

class Against {
public:
    explicit Against(EarlierEdit which) : which_(which) {}
    // A picture of this edit comes.  Edits without a look, as of fewer than two frames, are passed over.
    void begin(int64_t edit);
    // keys: of the columns; what has the same key can be compared.
    void look(const uncertainty::Replicates& replicates, const std::vector<std::string>& keys,
              const std::vector<uncertainty::Quantity>& quantities);
    // At the last look that both have; nan: there is none, or the earlier edit lacks the column.
    uncertainty::Estimate difference(size_t column) const;

private:
    struct Look {
        uncertainty::Replicates replicates;
        std::vector<std::string> keys;
    };
    EarlierEdit which_;
    int64_t edit_ = 0;
    std::vector<Look> earlier_, own_;
    std::vector<uncertainty::Estimate> differences_;  // empty: there are none
};

}  // namespace report
