// SPDX-License-Identifier: BSD-3-Clause
// The declarations of vcmetrics' options (CONTRIBUTING.md, "Add an option"): our own are words, those of one letter are
// evalglare's.
#pragma once
#include "base/options.h"
#include "options.h"

void declare_options(base::OptionTable& table, Options& options, view::View& view);  // view: of -vp -vd ...
void declare_evalglares_options(base::OptionTable& table, Options& options);

// "-like evalglare", which some of evalglare's options imply, and "-like accelerad".
void apply_compatibility(OutputMode program, Options& options);
