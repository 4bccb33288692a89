// SPDX-License-Identifier: BSD-3-Clause
// The options of ptaccum.  To add one: CONTRIBUTING.md, "Add an option".
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "display/tone.h"
#include "film/accumulate.h"

struct Options {
    std::string command;               // the whole command line, for headers
    std::vector<std::string> inputs;   // none: stdin
    std::vector<std::string> outputs;  // -o, may repeat: files
    bool to_stdout = true;             // no -o, or one of them is "-"
    film::Schedule schedule;           // -every
    bool every_given = false;
    bool last_only = false;               // -last
    std::optional<double> until_percent;  // -until: of blocks' error
    bool floats = false, bytes = false;   // -ff -fc: not what output.h says
    display::ToneOptions tone;
    bool filter = true;          // -filter: PNG files of frames that come in
    std::optional<int> batches;  // -batches: so many, for OpenEXR files
    bool keeps_parts = false;    // of frames
    bool half = false;           // -half: OpenEXR with 16-bit floats
};

// Nothing: help or version was printed.
std::optional<Options> parse_options(int argc, char** argv);
