// SPDX-License-Identifier: BSD-3-Clause
// Rows as text: a table or JSON lines of metrics or of glare sources, or evalglare's lines.
#pragma once
#include <string>
#include <vector>
#include "options.h"
#include "run.h"

// The heading of the rows; it is printed again where the columns have changed.
struct Heading {
    std::vector<std::string> names;  // of the last one
    bool views = false, skies = false, states = false,
         edits = false;  // pictures are named, as those of ptrace -views, -sky, -watch
    bool paths = false;  // some of them share their paths
    bool hours = false;  // they say which of how many hours they are
};

struct RowText {
    Heading heading;
    std::string names, lines;  // the line of names, if it is due
};
RowText text_of(const Options& options, Heading heading, const RunState& run, const Row& row);
