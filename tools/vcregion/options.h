// SPDX-License-Identifier: BSD-3-Clause
// vcregion's command line: RADIANCE's view and size options and a few words.
// To add an option: CONTRIBUTING.md, "Add an option".
#pragma once
#include <optional>
#include <string>
#include <vector>
#include "base/find_file.h"
#include "view/view.h"

struct Options {
    std::string command;  // the whole command line, for headers
    view::View view;
    bool view_given = false;
    int nx = 512, ny = 512;
    double pixel_aspect = 1;           // -pa, 0 keeps both sides
    bool centre = false;               // -centre: in or out by the pixel's centre
    bool list = false;                 // -list
    double spacing = 0, height = 0;    // -spacing, -height: of points; no spacing: masks
    std::string single;                // -single: one region as an evalglare mask
    std::string over;                  // -over: the picture under a preview
    std::vector<std::string> outputs;  // -o, the ending says what
    bool warnings = true;              // -w
    base::ReadOptions files;           // RAYPATH, -exec
    std::string regions;
    std::vector<std::string> scene;
};

// Fills opt and checks it.  A status: the answer (-help, -version, -defaults) was printed, main ends with it.
std::optional<int> parse_options(int argc, char** argv, Options& opt);
