// SPDX-License-Identifier: BSD-3-Clause
// In a live stream: the difference of columns between the picture of one edit and that of an earlier one, at the same
// number of frames (uncertainty/difference.h).  Of an edit the replicates' values of each look are kept, not pictures.
#pragma once
#include <string>
#include <vector>
#include "uncertainty/difference.h"

namespace report {

enum class EarlierEdit { none, previous, first };

struct Edits {
    struct Look {
        uncertainty::Replicates replicates;
        std::vector<std::string> keys;  // of the columns; what has the same key can be compared
    };
    int64_t edit = 0;                                // the last one that had a look
    std::vector<Look> earlier, own;                  // of the edit to compare with, and of that one
    std::vector<uncertainty::Estimate> differences;  // at its last look that both have; empty: there is none

    // nan: not known, or the earlier edit lacks the column.
    uncertainty::Estimate difference(int64_t of_edit, size_t column) const;
};

// With a look at a picture of this edit.  Edits without one, as of fewer than two frames, are passed over.
Edits add(Edits edits, EarlierEdit which, int64_t edit, Edits::Look look,
          const std::vector<uncertainty::Quantity>& quantities);

}  // namespace report
