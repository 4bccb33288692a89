// SPDX-License-Identifier: BSD-3-Clause
// Hours that could change the verdict, and how to decide them: more frames against noise, a larger picture against the
// error of pixels, which halves when its sides double.
#pragma once
#include <string>
#include <vector>

#include "year/verdict.h"

namespace year {

struct Need {
    Hour hour;
    double limit = 0;   // that its interval holds
    double frames = 0;  // in all, by which noise alone would decide
    int larger = 1;     // times the sides of the picture
};

// Nothing where the class is decided; else hours around the limits between the possible classes, the nearest first.
std::vector<Need> needs(const View& view, const Verdict& verdict);

// A table: the hour's name, frames, size (sides, times 64 x 64 or the table's), limit, view; lines that ptrace -hours
// @file reads.
std::string need_lines(const std::vector<View>& views, const std::vector<Verdict>& verdicts);

}  // namespace year
