// SPDX-License-Identifier: BSD-3-Clause
// The main loop: read a picture, measure it, print its line at once, look whether to stop.
#pragma once
#include "image/picture.h"
#include "options.h"

int measure_all(const Options& options);  // exit status

// Conversion of a file's numbers by the reader.
image::Pixels pixels_for(const Options& options);
