// SPDX-License-Identifier: BSD-3-Clause
// LEED v4.1, EQ credit Daylight, option 1: points by sDA300/50% over all spaces, and what their ASE1000,250 says of
// glare.  After leeduser.buildinggreen.com, EQc7 of v4.1, and ClimateStudio's page on LEED option 1.
#pragma once
#include <string>
#include <vector>

#include "year/autonomy.h"

namespace year {

struct LeedSpace {
    std::string name;
    Bounded spatial;     // sDA
    bool glare = false;  // ASE above 10 %, or maybe
};

struct Leed {
    Bounded spatial;  // sDA over all sensors of all spaces
    int points = 0, low = 0, high = 0;
    bool each = false, each_maybe = false;  // each space has 55 %: exemplary, or a point more where there are 1 or 2
    size_t sensors = 0;
    std::vector<LeedSpace> spaces;
    std::vector<std::string> lacks;  // what LM-83 asks and the tables do not have
};

Leed judge_leed(const std::vector<GridYear>& spaces, const Goals& goals);
std::string lines_of(const Leed& leed);

}  // namespace year
