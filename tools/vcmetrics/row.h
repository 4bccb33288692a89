// SPDX-License-Identifier: BSD-3-Clause
// The columns of a line of numbers by name, and its cells: values, their intervals, differences from an earlier edit.
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "glare/columns.h"
#include "report/against.h"
#include "report/estimates.h"
#include "report/table.h"
#include "options.h"

struct RowOfPicture {
    const glare::Measurement& measurement;
    int64_t frame;
    const report::ColumnEstimates* estimates;  // null: no column needs them
    const report::Against& against;
    bool settled;
};

// Whether pictures are named, as streams of several views, skies or edits do (ptrace -views, -sky, -watch).
struct NamedPictures {
    bool view = false, sky = false, edit = false;
};
NamedPictures named_pictures(const image::Header& first);

std::vector<std::string> start_names(const Options& options, const NamedPictures& named);
std::vector<report::Cell> start_cells(const Options& options, const NamedPictures& named, const image::Header& header,
                                      const std::string& file, int64_t frame, double seconds);

std::vector<std::string> row_names(const Options& options, const std::vector<glare::Column>& columns);
std::vector<report::Cell> row_cells(const Options& options, const std::vector<glare::Column>& columns,
                                    const RowOfPicture& row);

std::vector<std::string> source_names(const Options& options);
// A line for each source.
std::vector<std::vector<report::Cell>> source_rows(const Options& options, const glare::Measurement& m,
                                                   const glare::Geometry& geometry);
