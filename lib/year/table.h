// SPDX-License-Identifier: BSD-3-Clause
// The hours of a year from vcmetrics' tables (ptrace -wea): of each hour and view the line of the largest picture, of
// equal ones that with most frames, else the last one; of each hour and sensor the last line.
#pragma once
#include <string>
#include <vector>

#include "uncertainty/counts.h"
#include "uncertainty/halves.h"
#include "weather/date.h"

namespace year {

constexpr double normal_quantile = 1.959964;  // of the 95 % by which an hour is decided
constexpr double pixels_of_64 = 3217;         // in a circle of 64 x 64

struct Hour {
    weather::Time time;          // its middle
    uncertainty::Uncertain dgp;  // without the bias of noise; the bound is that of its pixels
    double frames = 0, pixels = pixels_of_64;
    double least_pixels = pixels_of_64;  // of the smallest of its pictures
    bool dark = false;                   // no light at all
    bool is_missing = false;             // the weather file has no values (rows of nan): any DGP is possible
    uncertainty::Halves halves;          // of dgp, where the table has them
    std::string paths;                   // the same in hours of one set of paths; empty: the hour has its own
    bool is_known = true;                // false: no interval came with so few frames, so that any value is possible
    std::string shades = {};             // their states, and the rules that close them, in words
    std::vector<Hour> states = {};       // of shades, any of which it may have; dgp holds all of them
    double low() const, high() const;    // of the 95 % interval, with the pixels' error
};

struct View {
    std::string name;         // empty: the only one
    std::vector<Hour> hours;  // by time
    bool shared = false;      // hours have paths in common: all have half-samples
    size_t to_come = 0;       // hours of its run that are not there (wanted.h)
};

struct Lux {
    float value = 0, error = 0;  // one standard error
};

struct GridHour {
    weather::Time time;
    std::vector<Lux> sensors;
    std::vector<uncertainty::HalfCodes> halves = {};  // of each sensor; empty: not known
    double degrees = uncertainty::Uncertain::infinite, strata = 0;
    std::string paths = {};
    std::vector<GridHour> instead = {};  // what it may be as well, where the state of shades is in doubt
};

bool is_dark(const GridHour& hour);
bool is_missing(const GridHour& hour);

// Illuminances of sensors, at least one in at least one hour.
struct Grid {
    std::string name;
    std::vector<GridHour> hours;  // by time, all with the same sensors
    bool shared = false;          // as of a view
    double strata = 0;            // fewest of an hour that has light; 0: half-samples are not known
    size_t to_come = 0;           // as of a view
    size_t sensors() const { return hours.front().sensors.size(); }
};

struct Tables {
    std::vector<View> views;  // in the order of their first lines
    std::vector<Grid> grids;  // likewise; there are either views or grids
    std::vector<Grid> edi;   // of the column mEDI, where there is one: of the same grids, or of views as single sensors
    bool exact = false;      // no intervals: values are taken as they are
    bool no_errors = false;  // limits without their standard errors: they count as of 95 %
    bool no_pixels = false;  // no column pixels: pictures count as 64 x 64
};

// The tables of a state of shades (ptrace -state); "" where the scene has none.
struct StateTables {
    std::string state;
    Tables tables;
};

// Throws Error (place: the hour) where there are none: counts of a year whose hours share paths need those of all
// hours.
void require_half_samples(const weather::Time& time, double strata);

// Files and lines come in any order but for hours that were rendered twice at one size with as many frames.  Throws
// Error (place: the file) for tables without hours, or without DGP or E, or in which no hour has an interval.
std::vector<StateTables> read_states(const std::vector<std::string>& paths);  // in the order of their first lines
// The only state.  Throws Error (place: the first file) where there are several.
Tables read_tables(const std::vector<std::string>& paths);

}  // namespace year
