// SPDX-License-Identifier: BSD-3-Clause
// Pictures of points (ptrace -points): numbers of their grids, a row a picture; or a row a point (-each), or rtrace's
// lines (-like rtrace), of the last picture of each sky.
#pragma once
#include <optional>
#include <string>
#include "image/picture.h"
#include "options.h"
#include "report/grids.h"
#include "report/until.h"
#include "stopping.h"

// State between two pictures; without columns there was none yet.
struct GridState {
    std::vector<report::GridColumn> columns;
    std::vector<std::string> names;  // of the table's columns
    std::vector<report::Tolerance> rule;
    std::vector<report::GridColumn> of_rule;  // the column of each tolerance
    image::GrowingParts parts;
    image::Header header;    // of the last picture
    std::vector<float> rgb;  // its pixels
    std::vector<uncertainty::NoisyValues> grids;
    std::vector<image::Point> points;  // of -points, where they are needed
    int held = 0;                      // how many pictures in a row the rule has held at
    Progress progress;
};

struct GridStep {
    GridState state;
    std::string text;  // rows to print
    Verdict verdict;
};
// Uses up the picture's pixels.
GridStep step(const Options& options, GridState state, image::Picture& picture, int64_t frame, double seconds);

// Writes the file of -over: maps of the last picture's points and of the half-widths of their intervals.
void draw_map(const Options& options, const GridState& state);

// After the last sum of a picture: why it has no intervals, where they are asked for.
void tell_if_alone(const Options& options, const GridState& state);
// The rows of -each and -like rtrace, of the state's picture.
std::string rows_of_points(const Options& options, const GridState& state);
