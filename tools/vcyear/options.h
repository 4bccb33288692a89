// SPDX-License-Identifier: BSD-3-Clause
// vcyear's command line.  To add an option: CONTRIBUTING.md, "Add an option".
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/table.h"
#include "year/autonomy.h"

struct Options {
    std::vector<std::string> tables;
    std::vector<std::string> direct;            // -direct: tables of a run with direct sun alone
    std::vector<std::string> points;            // -points: of -plot of grids
    std::vector<std::string> closed;            // -closed: tables of a run with closed shades
    std::string shades;                         // -shades: a file of rules, or rules
    std::vector<std::string> by;                // -by: tables that rules read
    std::string moves;                          // -moves: a table of which state shades have, and why
    std::string state;                          // -state: this one alone
    double close_dgp = .4;                      // -close
    year::Goals goals;                          // -sda, -udi, -ase
    std::string en17037;                        // -en17037: the weather file of the year
    std::string sun_steps;                      // -sunlight: the weather file of the steps
    double lowest_deg = 0;                      // -sunlight: of the sun
    std::string overcast;                       // -overcast: a table of the sensors
    double outdoor_lux = 0;                     // -overcast
    bool leed = false, months = false;          // -leed, -months
    bool rooflight = false;                     // -rooflight: its openings are horizontal
    bool each = false;                          // -each: a row a sensor
    std::string view;                           // -view: this one alone
    std::string command = "ptrace ...";         // -command: without -hours
    std::string plot, honeybee;                 // -plot, -honeybee
    std::string report, title;                  // -report, -title
    std::vector<std::string> eyes, pictures;    // -views, -pictures: of the report
    std::string plan, weather;                  // -plan, -wea: likewise
    std::vector<std::string> planes, openings;  // -plane, -openings: tables of sensors, of the report
    std::string view_out;                       // -viewout: what vcregion -list printed
    bool next = false;                          // -next
    int worst = 0;                              // -worst
    std::optional<report::TableFormat> format;  // -format; none: text
    double percent = 95;                        // -ci
    bool warnings = true;                       // -w
};

// Fills opt and checks it.  A status: the answer (-help, -version, -defaults) was printed, main ends with it.
std::optional<int> parse_options(int argc, char** argv, Options& opt);
