// SPDX-License-Identifier: BSD-3-Clause
// vcmetrics' command line.  One-letter options are evalglare's, with its meanings; ours are words.
// To add an option: CONTRIBUTING.md, "Add an option".
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "base/find_file.h"
#include "evalglare/settings.h"
#include "glare/settings.h"
#include "report/against.h"
#include "report/criterion.h"
#include "report/table.h"
#include "view/view.h"

enum class OutputMode { vcmetrics, evalglare, accelerad };

struct Options {
    glare::Settings settings;
    std::vector<std::string> files;  // empty: stdin
    std::string regions_file;
    std::vector<std::string> contrast_pairs;
    std::vector<std::string> spectra;       // -spectrum: lights to judge, in place of pictures
    std::vector<std::string> metrics;       // empty: the default columns
    std::vector<std::string> points_files;  // -points: of pictures of points
    bool each = false;                      // -each: a row a point
    bool last = false;                      // -last: no row of a sum that another follows
    bool like_rtrace = false;               // -like rtrace: its lines, of points
    bool list_sources = false;
    bool outlines = false;                                   // of sources
    std::string over_file;                                   // -over; empty: none
    std::string report_file, numbers_file;                   // -report, -numbers
    std::string plan_map, plan_numbers;                      // -plan
    std::vector<std::string> scene;                          // -scene: of the report
    std::vector<std::pair<std::string, std::string>> about;  // -about: likewise
    struct Variant {
        std::string name, picture, lines;  // files
    };
    std::vector<Variant> variants;            // -variant: likewise
    std::string day;                          // -day: likewise
    std::vector<report::Criterion> criteria;  // -criterion: likewise
    base::ReadOptions scene_options;
    std::vector<std::pair<std::string, std::string>> overlays;  // -overlay: file and the one that has its text
    report::TableFormat format = report::TableFormat::tsv;
    OutputMode mode = OutputMode::vcmetrics;
    bool evalglare_bug_compatible = false;  // its rounding and its slips (lib/evalglare), also where columns are ours
    evalglare::Settings evalglare;
    std::string until;
    std::optional<double> ci;  // -ci: NAME.lo and NAME.hi, this certain (a share)
    bool halves = false;       // -halves: half-samples beside each interval
    std::string against;       // -against: NAME.d and its interval; empty: none
    bool go_on = false;        // -go-on: -until ends nothing
    std::optional<int64_t> max_frames;
    std::optional<double> max_seconds;
    std::string control;  // -control: a FIFO of the renderer; empty: none
    bool difference = false;
    bool warnings = true;
    std::string check_file;                 // -c
    std::string command;                    // the whole command line, for its header
    std::optional<std::string> tolerances;  // of -difference: rules, or a file of them
    std::optional<view::View> view;         // replaces the header's
};

// A status: help, version or defaults were printed, main() ends with it.
std::optional<int> parse_options(int argc, char** argv, Options& options);
