// SPDX-License-Identifier: BSD-3-Clause
// The commands that make the picture of a report (report_file.h) and its numbers again: a script that runs as it is in
// a copy of the folder, also where files were changed in the page and never saved.
#pragma once
#include <string>
#include <vector>

#include "image/picture.h"
#include "options.h"
#include "report/page.h"

// regions: names of those that the picture has.
std::vector<std::string> commands_of(const Options& options, const image::Picture& picture, const std::string& view,
                                     const std::vector<std::string>& regions);

// In a live page columns wait for regions that nobody may draw: their numbers are of no use in a report.
void leave_out_undrawn(const std::vector<std::string>& regions, std::vector<report::Page::Number>& numbers);

// The lines of a text file.
std::vector<std::string> lines_in(const std::string& file);
