// SPDX-License-Identifier: BSD-3-Clause
// A run, picture by picture: what is known before a picture and the picture itself give its row and what is known
// after.
#pragma once
#include <chrono>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "image/picture.h"
#include "report/against.h"
#include "report/errors.h"
#include "report/sum.h"
#include "run_plan.h"

struct RunState {
    RunPlan plan;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    glare::Reading reading;  // of the last picture
    report::Sum sum;         // which it is a step of
    report::Edits edits;
    Progress progress;
};

// Where a picture comes from.
struct PicturePlace {
    std::string text;  // for messages
    std::string file;
    long index = 0;  // in its file
};
PicturePlace place_of(const std::string& file, long index);  // file: "-" is the standard input
int64_t frame_number(const image::Header& header, const PicturePlace& place);
// Does a sum of the same picture follow this one?  Unknown: no.
bool is_followed(const image::Header& header, int64_t frame);

// A value, and the interval around `middle`, which may be another one.
struct Number {
    double value, middle;
    uncertainty::Interval off;  // nan: none
    report::NumberError error;  // likewise
};
struct Row {
    std::string file, view, sky, state;  // view, sky, state: their names
    std::string paths;                   // the same in rows that share them; empty: none
    std::string hour;                    // "3/2600", "-"; empty: none
    std::optional<int64_t> edit;
    int64_t frame;
    double seconds;                   // since the start of the run
    std::vector<Number> numbers;      // of the columns of the run's plan
    std::vector<Number> differences;  // likewise, with -against
    std::string heavy_tailed;         // names of columns
    bool settled = false;
    bool may_be_black = false;  // no values, an hour without daylight, or the light of paths may come with later frames
    glare::Measurement measurement;
    Verdict verdict;
};

// Throws Error for a picture that cannot be measured.
void require_measurable(const image::Picture& picture, const std::string& place);

// No row: the picture is passed over.  Uses up the picture's pixels.
std::pair<RunState, std::optional<Row>> step(const Options& options, RunState run, image::Picture& picture,
                                             const PicturePlace& place);
