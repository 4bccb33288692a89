// SPDX-License-Identifier: BSD-3-Clause
// A growing sum of frames, picture by picture: its parts and the last look at them.
// A look is due after 2, 3, 4, 6, 8, 11, 16, 23 ... frames; it measures the picture and its replicates.
#pragma once
#include <string>
#include <vector>
#include "image/picture.h"
#include "report/estimates.h"

namespace report {

constexpr const char* no_batches =
    "a picture by itself holds no batches of frames; the stream of sums does (ptaccum without -last), and an OpenEXR "
    "file (ptaccum -o file.exr)";

struct Sum {
    image::GrowingParts growing;
    std::vector<image::Part> taken;  // of a picture that came with its parts; else empty
    uncertainty::Frame0Error frame0_error;
    int64_t last = -1;                // frames of the last picture; -1: there was none
    bool step = false, ends = false;  // the last picture is one of a sum; none follows it
    int64_t next_look = 2;            // frames
    bool again = false;               // a look is due beside those
    bool looked = false;              // `look` is of the last picture
    Look look;
    bool reported = false, warned = false;  // in this run: no intervals, large steps

    const std::vector<image::Part>& parts() const { return taken.empty() ? growing.parts() : taken; }
};

// With a picture that was read.  reports: why it is no step of a sum.  passes: there is no look at it, but at a later
// one.
Sum add(Sum sum, const image::Picture& picture, const glare::Reading& reading, const std::string& place, bool reports,
        bool passes = false);
// With a look at that picture, where one is due; those before `first_look` frames are left out.
Sum look(Sum sum, const glare::Reading& reading, const glare::Measurement& measurement,
         const std::vector<glare::Column>& columns, int64_t first_look);
// The columns are others from here on: a look is due.
Sum without_look(Sum sum);
// After the last picture of a file: another sum begins.
Sum end_input(Sum sum, const std::string& place, bool reports);

}  // namespace report
