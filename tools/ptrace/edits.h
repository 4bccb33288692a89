// SPDX-License-Identifier: BSD-3-Clause
// Edits as values: what a run is, and what commands of -control make of it (docs/decisions/0034-edits.md).
#pragma once
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "options.h"
#include "render/command_reader.h"

// What edits change of a run.
struct Run {
    Options opt;
    int64_t edits = 0;             // so many pictures began anew by one
    std::string edited = "start";  // what the picture began with, as its header says
    std::string last;              // word of the last command that asked for a picture
    std::string changed;           // of the last that neither asks for a preview nor ends one
    std::string note;              // words of "note", for the next full picture of an edit
};

// What a picture needs after edits.
enum class Work { nothing, view, files };

struct Edited {
    Run run;
    Work work = Work::nothing;
    std::vector<std::string> refused;  // lines that say which commands could not be carried out, and why
};
// picture: of opt.views, the one at hand.
Edited edited(Run run, const std::vector<render::Command>& commands, size_t picture);

// The run as its picture goes on, and as it begins anew.
Run gone_on(Run run);
Run begun(Run run);
