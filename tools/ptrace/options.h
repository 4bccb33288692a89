// SPDX-License-Identifier: BSD-3-Clause
// ptrace's command line: rpict's view and rendering options, read in order, plus our own few words.
// To add an option: CONTRIBUTING.md, "Add an option".
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/processors.h"
#include "scene/object.h"
#include "trace/options.h"
#include "view/view.h"

struct Options {
    trace::RenderOptions render;
    view::View view;
    int nx = 512, ny = 512;
    double pixel_aspect = 1;            // -pa, 0 keeps both sides
    double exposure = 1;                // -rif: of the pictures written
    int64_t first = 0, last = endless;  // frames, both included
    std::string device = "auto";
    std::string rule_for;                   // -M: the target of a rule of make; empty: render
    std::string command;                    // the whole command line, for the headers of the frames
    std::string output;                     // -o pattern; empty: stdout
    int threads = int(base::processors());  // -n
    int report_s = 0;                       // -t: a line on stderr every so many seconds
    bool warnings = true;                   // -w
    scene::ReadOptions files;               // RAYPATH, -exec
    std::vector<std::string> scene_files;

    static constexpr int64_t endless = 0xfffffffe;  // the samplers count frames in 32 bits
};

// Fills opt and checks it.  A status: the answer (-help, -version, -defaults, -devices) was printed, main ends with it.
std::optional<int> parse_options(int argc, char** argv, Options& opt);

// The file of frame k: the pattern's one %d (%4d, %04d) replaced; a pattern without serves a single frame.
std::string output_name(const std::string& pattern, int64_t k);
