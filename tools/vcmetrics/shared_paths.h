// SPDX-License-Identifier: BSD-3-Clause
// What rows of hours say of errors that they may have in common (year/table.h reads it).
#pragma once
#include <string>

#include "image/picture.h"
#include "options.h"

// Half-samples: of the last rows of skies and hours, or with -halves of all.
bool prints_halves(const Options& options, const image::Header& header);

// The same for pictures whose paths are the same: those of one set, seeds and frames.  Empty: they are the picture's
// own.
std::string paths_of(const image::Header& header);
