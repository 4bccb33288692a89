// SPDX-License-Identifier: BSD-3-Clause
// In a live stream: the difference of columns between the picture of one edit and that of an earlier one, at the same
// number of frames (uncertainty/difference.h).  It keeps the replicates' values of an edit at each look, not its
// pictures.
#pragma once
#include <map>
#include <string>
#include <vector>
#include "uncertainty/difference.h"

namespace report {

struct Edits {
    struct Look {
        uncertainty::Replicates replicates;
        std::vector<std::string> keys;  // of the columns; what has the same key can be compared
        std::vector<uncertainty::Quantity> quantities;
    };
    int64_t edit = 0;                                // of the newest picture
    int64_t previous = -1, base = -1;                // the last one before it that had a look; the one to compare with
    std::map<int64_t, std::vector<Look>> earlier;    // by edit
    std::vector<Look> own;                           // of the newest picture's
    std::vector<uncertainty::Estimate> differences;  // at its last look that both have; empty: there is none

    // nan: not known, or the earlier edit lacks the column.
    uncertainty::Estimate difference(size_t column) const;
};

// A picture of this edit comes, to be compared with an earlier one: "previous", "first", or what a file says, one of
// these words or the number of an edit, which may change meanwhile.  Edits without a look, as of fewer than two
// frames, are passed over.
Edits begin(Edits edits, const std::string& which, int64_t edit);
// With a look at it.
Edits add(Edits edits, Edits::Look look);

}  // namespace report
