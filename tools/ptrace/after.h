// SPDX-License-Identifier: BSD-3-Clause
// -after: a run goes on where another one ended, with the next frame of a sum or with the hours that a table lacks.
#pragma once
#include "options.h"

// Reads the files of -after, when frames, views and hours are known.  seed_given: the sum's is taken where it is not.
void go_on_after(Options& opt, bool seed_given);

// Is picture i of a sky in a table of -after?
bool is_rendered(const Options& opt, size_t i, const Sky& sky);
