// SPDX-License-Identifier: BSD-3-Clause
// Hours that could change the verdict, and how to decide them: more frames against noise, a larger picture against
// noise and the error of pixels, whichever costs less.
#pragma once
#include <string>
#include <vector>

#include "year/verdict.h"

namespace year {

struct Need {
    Hour hour;
    double limit = 0;                 // that its interval holds
    double frames = 0;                // of the picture that would decide it
    int larger = 1;                   // times the sides of the hour's picture
    double price = 0;                 // in frames of 64 x 64 pixels
    uncertainty::Uncertain promised;  // DGP of this picture if the value stays
};

// The cheapest hours that would decide the class, as few as are enough if their values stay; all that could change it
// where even these are not; those first that help most.  Nothing where the class is decided, or no picture could decide
// it.
std::vector<Need> needs(const View& view, const Verdict& verdict, double alpha);

// A table: the hour's name, frames, times the sides of the view's smallest picture, limit, view; lines that ptrace
// -hours @file reads.
std::string need_lines(const std::vector<View>& views, const std::vector<Verdict>& verdicts, double alpha);

}  // namespace year
