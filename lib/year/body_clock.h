// SPDX-License-Identifier: BSD-3-Clause
// Light for the body clock in the hours of a year: melanopic equivalent daylight illuminance (CIE S 026, column mEDI of
// the tables) of the limits of WELL v2, feature L03: at eyes, whose hours are counted, and at sensors, of which a share
// has it in a share of the hours.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "report/table.h"
#include "year/verdict.h"

namespace year {

constexpr std::array<double, 2> edi_limits{136, 250};  // lx

struct BodyClock {
    std::string name;
    size_t hours = 0, sensors = 0;
    double asked_share = 0;             // of the hours
    std::array<Bounded, 2> lit;         // share of the hours that have each limit or more, mean of the sensors
    std::array<Bounded, 2> of_sensors;  // share of them that have it in asked_share of the hours
};

// Of the view or grid of this name; none: the tables have no mEDI of it.  alpha: probability that an interval misses.
std::optional<BodyClock> judge_body_clock(const Tables& tables, const std::string& name, double asked_share,
                                          double alpha);

std::string words_of_view(const BodyClock& clock);  // "desk: 136 lx in 3, 250 lx in 1 of 4 hours"
std::string line_of_view(const BodyClock& clock);
std::string line_of_sensors(const BodyClock& clock);
void add_view(report::Line& line, const BodyClock& clock);
void add_sensors(report::Line& line, const BodyClock& clock);

}  // namespace year
