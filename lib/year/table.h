// SPDX-License-Identifier: BSD-3-Clause
// The hours of a year from vcmetrics' tables (ptrace -wea): the last line of each hour and view.
#pragma once
#include <string>
#include <vector>

#include "uncertainty/counts.h"
#include "weather/date.h"

namespace year {

struct Hour {
    weather::Time time;             // its middle
    uncertainty::Uncertain dgp;     // without the bias of noise; the bound is that of its pixels
    double frames = 0, pixels = 0;  // pixels: of its picture; 0: not in the table
    bool dark = false;              // no light at all
    bool is_known = true;           // false: no interval came with so few frames, so that any value is possible
    double half_width() const;      // of the 95 % interval, without the pixels' bound
};

struct View {
    std::string name;         // empty: the only one
    std::vector<Hour> hours;  // by time
};

struct Tables {
    std::vector<View> views;  // in the order of their first lines
    bool exact = false;       // no intervals: values are taken as they are
    bool no_pixels = false;   // no column pixels: pictures count as 64 x 64
};

// Later files, and later lines, replace what was said of an hour.  Throws Error (place: the file) for tables without
// hours or DGP, or in which no hour has an interval.
Tables read_tables(const std::vector<std::string>& paths);

}  // namespace year
