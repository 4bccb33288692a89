// SPDX-License-Identifier: BSD-3-Clause
// The file of -report: gathers what a page (report/page.h) says of a picture that was measured.
#pragma once
#include "image/picture.h"
#include "options.h"
#include "run.h"

// picture: as it was read.
void write_report(const Options& options, const image::Picture& picture, const RunState& run, const Row& row);
