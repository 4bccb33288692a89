// SPDX-License-Identifier: BSD-3-Clause
// When a run ends by itself, and the line on stderr that says why: -until, -max-frames, -max-seconds.  With -control
// each picture of the stream ends by itself: its renderer is sent "next", and its further sums are passed over.  With
// -go-on nothing ends where the rule holds: a column says so.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>
#include "glare/columns.h"
#include "options.h"
#include "report/estimates.h"
#include "report/until.h"

// -until, by the places of its columns in a run.
struct StopRule {
    std::optional<report::UntilRule> rule;      // none: it was not given
    std::vector<size_t> watched;                // columns of the rule, in its order
    std::vector<std::optional<size_t>> pixels;  // their columns NAME.px
    size_t dgp = 0;                             // for the class
    std::optional<size_t> dgp_pixels;
    std::string of_filled;  // a metric of the rule that there is not without moments of pixels
};
// Throws Error if the rule names a column that the run does not have, or that has no interval.
StopRule stop_rule(const Options& options, const std::string& until, const std::vector<glare::Column>& columns);
// The parts of -until that a picture of -control is to meet: of these columns.
std::string parts_of_rule(const std::string& until, const std::function<bool(const std::string& column)>& counts);

// Progress of the present picture, and the decision on it.
struct Progress {
    int64_t frames = -1;                // of the last sum; -1: there was none
    std::string label;                  // of the picture
    bool held = false, missed = false;  // the rule: of this picture; not of one before it
    bool done = false;                  // all is said of this picture; without -go-on no more of it is measured
};
// With a sum of n frames of the picture `label`, which comes.
Progress begin(const Options& options, Progress progress, const std::string& label, int64_t n);

struct MeasuredSum {
    int64_t frames;
    double seconds;              // since the start
    const report::Look* looked;  // a look at this sum; null: there was none
    bool moments = false;        // the picture has moments of its pixels
    int width = 0, height = 0;
    bool last = false;  // its stream announces no more frames
};
// What -until comes to at a sum: why it holds, or why it never will.
struct RuleState {
    bool holds = false;
    std::string reason, out_of_reach;
};
RuleState rule_state(const StopRule& rule, const MeasuredSum& sum);

struct Verdict {
    bool stops = false;         // the run ends with this row
    std::string says, command;  // why, and what the renderer is sent, after the row; empty: nothing
};
std::pair<Progress, Verdict> decide(const Options& options, const RuleState& state, Progress progress,
                                    const MeasuredSum& sum);

void say_end(const Options& options, const Progress& progress);  // of the input or a picture, without a stop
// Status 0 if the rule holds or there is none, else 4.
int status(const Options& options, const Progress& progress);
