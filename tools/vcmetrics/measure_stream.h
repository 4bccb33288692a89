// SPDX-License-Identifier: BSD-3-Clause
// The main loop: read a picture, measure it, print its line at once, look whether to stop.
#pragma once
#include "options.h"

int measure_all(const Options& options);  // exit status
