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

// Ordinary pictures, or those of an action (ACTION=) of the same points, sky and state.
struct GridKind {
    std::string illuminance;  // of the action, "mEDI"; empty: ordinary ones
    image::GrowingParts parts = image::GrowingParts();
    std::vector<uncertainty::NoisyValues> grids = {};  // of the last picture; empty: none has come
    int64_t frames = -1;
    bool ended = false;
};
struct GridCell {
    report::GridColumn column;
    size_t kind = 0;
};

// State between two pictures; without kinds there was none yet.
struct GridState {
    std::vector<GridKind> kinds;  // ordinary ones first
    std::vector<GridCell> columns;
    std::vector<std::string> names;  // of the table's columns
    std::string held_back;           // with -last: the row, until the pictures of its actions have come
    std::vector<report::Tolerance> rule;
    std::vector<GridCell> of_rule;     // the column of each tolerance
    image::Header header;              // of the last picture
    std::vector<float> rgb;            // pixels of the last ordinary one
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
