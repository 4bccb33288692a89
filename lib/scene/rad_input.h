// SPDX-License-Identifier: BSD-3-Clause
// Input files of rad(1) (.rif): which scene files, rendering options and views a picture is made of.
// Read are the variables that mean something to a path tracer; those of rad's cache, thresholds and post-processing
// are checked for their names only.
#pragma once
#include <string>
#include <vector>

namespace scene {

struct RadInput {
    struct NamedView {
        std::string name;                // empty: unnamed, known by its number from 1
        std::vector<std::string> words;  // view options; UP's -vu stands first
    };
    std::string path;
    std::vector<std::string> scene_files;  // materials, illum, scene in this order; else OCTREE
    std::vector<std::string> options;      // -x -y ... and what render= and rpict= say, in rad's order
    std::vector<NamedView> views;
    double exposure = 1;                  // a factor
    double zone[6] = {0, 0, 0, 0, 0, 0};  // xmin xmax ymin ymax zmin zmax
    bool has_zone = false, interior = false;
    int up_axis = 2, up_sign = 0;  // UP; sign 0: not given
};

// `more`: assignments that come after the file's, as on rad's own command line.
RadInput read_rad_input(const std::string& path, const std::vector<std::string>& more = {});

// The view called `name`: one of the file's, its number, or a standard one such as "X" or "xYzl" (needs ZONE).
// An empty name gives the first view, or "X" if there is none.  Throws Error if there is no such view.
std::vector<std::string> view_words(const RadInput& input, const std::string& name);

}  // namespace scene
