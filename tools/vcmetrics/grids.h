// SPDX-License-Identifier: BSD-3-Clause
// Pictures of points (ptrace -points): numbers of their grids, a row a picture; or a row a point (-each), or rtrace's
// lines (-like rtrace), of the last picture.
#pragma once
#include <optional>
#include <string>
#include "image/picture.h"
#include "options.h"
#include "report/grids.h"

// What is known before a picture.
struct GridState {
    std::vector<report::GridColumn> columns, asked;  // asked: by -until; no columns: there was no picture yet
    std::vector<std::string> names;
    image::GrowingParts parts;
    image::Picture last;
    std::vector<uncertainty::NoisyValues> grids;
    int held = 0;  // how many pictures in a row the rule has held at
    bool done = false;
};

struct GridStep {
    GridState state;
    std::string text;  // rows to print
    bool ends = false;
};
GridStep step(const Options& options, GridState state, const image::Picture& picture, int64_t frame, double seconds);

// What is left to print.
std::string rows_of_points(const Options& options, const GridState& state);
int status(const Options& options, const GridState& state);
