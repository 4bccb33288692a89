// SPDX-License-Identifier: BSD-3-Clause
// The commands that make the picture of a report (report_file.h) and its numbers again: a script that runs as it is in
// a copy of the folder, also where files were changed in the page and never saved.
#pragma once
#include <string>
#include <vector>

#include "image/picture.h"
#include "options.h"

// regions: names of those that the picture has.
std::vector<std::string> commands_of(const Options& options, const image::Picture& picture, const std::string& view,
                                     const std::vector<std::string>& regions);

// The lines of a text file.
std::vector<std::string> lines_in(const std::string& file);
