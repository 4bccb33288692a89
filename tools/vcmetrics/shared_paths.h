// SPDX-License-Identifier: BSD-3-Clause
// What rows of hours say of errors that they may have in common, and of the year that they are of (year/table.h reads
// it).
#pragma once
#include <string>

#include "image/picture.h"
#include "options.h"

// Half-samples: of the last rows of skies and hours, or with -halves of all.
bool prints_halves(const Options& options, const image::Header& header);

// The same for pictures whose paths are the same: those of one set, seeds and frames.  Empty: they are the picture's
// own.
std::string paths_of(const image::Header& header);
// Which of how many hours it is: "3/2600"; "-": one that was named; empty: none.
std::string hour_of(const image::Header& header);
