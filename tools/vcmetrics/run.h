// SPDX-License-Identifier: BSD-3-Clause
// A run, picture by picture: what is known before a picture and the picture itself give its row and what is known
// after.
#pragma once
#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>
#include "image/picture.h"
#include "numbers.h"
#include "report/against.h"
#include "report/sum.h"
#include "run_plan.h"

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
    int group = 0;         // rows of an ordinary picture and of its actions have the same one
    bool complete = true;  // no picture of an action is to come that would fill its cells
};

constexpr uncertainty::Estimate no_estimate{std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::quiet_NaN()};

// The pictures of one action that belong to the ordinary picture before them, up to the present one.
struct ActionPart {
    glare::Reading reading;
    report::Sum sum;
    std::optional<report::Look> look;  // the last one
    std::vector<Number> numbers;       // of the kind's columns
    bool seen = false, ended = false;
    int64_t frames = -1;
    std::string place;
};
// An ordinary picture and those of actions of the same view, sky, state and hour.
struct Group {
    int number = 0;
    std::string label, file;  // file: of the ordinary picture; empty: there is none
    std::optional<int64_t> edit;
    bool of_hour = false;                          // a year's actions come when all of its ordinary pictures have come
    std::vector<bool> seen_ever;                   // kinds, in this run
    std::optional<Row> ordinary;                   // its last row
    std::vector<uncertainty::Estimate> estimates;  // of ordinary columns
    bool moments = false;                          // it has them
    std::vector<uncertainty::Estimate> ratios;     // of the plan's cells, at the last look
    std::vector<ActionPart> actions;               // of the plan's kinds
    bool told_missing = false, told_other_ev = false;  // in this run
};

struct RunState {
    RunPlan plan;
    std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
    glare::Reading reading;  // of the last ordinary picture
    report::Sum sum;         // which it is a step of
    report::Edits edits;
    Group group;
    Progress progress;
};

// Names, frame and time of a picture's row.
Row row_of(const RunState& run, const image::Header& header, const PicturePlace& place);

// Throws Error for a picture that cannot be measured.
void require_measurable(const image::Picture& picture, const std::string& place);

// No row: the picture is passed over.  Uses up the picture's pixels.
std::pair<RunState, std::optional<Row>> step(const Options& options, RunState run, image::Picture& picture,
                                             const PicturePlace& place);
