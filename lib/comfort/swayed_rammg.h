// SPDX-License-Identifier: BSD-3-Clause
// RAMMG of swayed pictures, all in one walk down the rows.
#pragma once
#include <array>
#include <memory>
#include <vector>
#include "comfort/pyramid.h"
#include "comfort/rammg.h"
#include "comfort/swayed_pairs.h"

namespace comfort {

// As rammg() of each picture, but for the last bits of its sums.  Not for areas without the frame (interior,
// prototype_scale).
class SwayedContrast {
public:
    SwayedContrast(const Pyramid& pyramid, const Signs& signs);
    ~SwayedContrast();
    void take(const SwayedRow& here, const SwayedRow& before, int row);  // one row after the other, from the top
    std::array<double, Signs::most> of_pictures() const;

private:
    const Pyramid& pyramid_;
    const std::vector<Level>& levels_;
    const Signs& signs_;
    PairSums edge_, corner_;
    class Below;
    std::unique_ptr<Below> below_;  // the levels below the pixels
};

std::array<double, Signs::most> rammg(const Swayed& pictures, const Geometry& geometry, RammgArea area);

}  // namespace comfort
