// SPDX-License-Identifier: BSD-3-Clause
// The main loop: read a picture, measure it, print its line at once, look whether to stop.
#pragma once
#include "image/picture.h"
#include "report/compare.h"
#include "options.h"

int measure_all(const Options& options);  // exit status

// Measures these metrics of every picture of one input, into a table.
report::NumberTable measure_table(const Options& options, const std::string& file,
                                  const std::vector<std::string>& metrics);

// Conversion of a file's numbers by the reader.
image::Pixels pixels_for(const Options& options);
