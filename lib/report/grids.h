// SPDX-License-Identifier: BSD-3-Clause
// Numbers of grids of sensors (image/points.h): columns such as floor.mean, floor.share300.
#pragma once
#include <string>
#include <vector>
#include "image/points.h"
#include "report/until.h"
#include "uncertainty/points.h"

namespace report {

struct GridColumn {
    std::string name;  // "floor.share300"
    size_t grid = 0;
    enum class Kind { mean, min, max, median, percentile, share, U0, df, each } kind = Kind::mean;
    double argument = 0;  // percentile as a share; limit in lx
    size_t outside = 0;   // df: the grid called outside
};

constexpr const char* default_grid_numbers = "mean,min,median,p5,U0,share300,share500";
constexpr const char* grid_outside = "outside";

// Does the name end as such a column does?
bool may_be_of_grid(const std::string& name);
// Each name is GRID.NUMBER, or NUMBER of all grids (but of the grid called outside).  Throws Error (place).
std::vector<GridColumn> grid_columns(const std::vector<std::string>& names, const std::vector<image::Grid>& grids,
                                     const std::string& place);

struct GridNumber {
    double value = 0;
    uncertainty::Interval limits{0, 0};  // nan: not known
};
// Does a rule hold, with intervals of 95 %?  Of each: 95 of 100 points keep the tolerance of their own value.
bool holds(const Tolerance& rule, const GridColumn& column, const std::vector<uncertainty::NoisyValues>& grids);
// Not of each, which is a rule and no number.
GridNumber grid_number(const GridColumn& column, const std::vector<uncertainty::NoisyValues>& grids, double alpha);

}  // namespace report
