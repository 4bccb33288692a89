// SPDX-License-Identifier: BSD-3-Clause
// The four parts of EN 17037 on the page of a year (page.h): the level of each, its number, the rule in words, and what
// lacks to the next level.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "year/provision.h"
#include "year/sunlight.h"
#include "year/verdict.h"

namespace year {

// What vcregion -list says from one point: the share of a row of directions all around that the region "opening" takes,
// and the names of other regions, which are seen.
struct ViewOut {
    double sight_deg = 0;
    std::vector<std::string> seen;
};
// Throws Error (place: the file) where there is no row "opening".
ViewOut read_view_out(const std::string& path);

struct PageParts {
    struct Plane {
        std::string name, shades;  // shades: the state that is counted; empty: the scene has one
        Provision provision;
    };
    struct Openings {
        std::string name;
        Sunlight sunlight;
    };
    std::vector<Plane> planes;
    std::string daylight_hours;  // the weather file that says which they are
    std::vector<Openings> openings;
    std::optional<ViewOut> view_out;
    bool any() const { return !planes.empty() || !openings.empty() || view_out; }
};

// A table of the parts; verdicts: of glare.
std::string parts_table(const PageParts& parts, const std::vector<Verdict>& verdicts, double certainty);

}  // namespace year
