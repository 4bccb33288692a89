// SPDX-License-Identifier: BSD-3-Clause
// A run measures by a plan.  In a live stream, whose pictures say EDIT=, the region file is read again when it has
// changed, which gives another plan; a region that is out of sight is nan.
#pragma once
#include <string>
#include <vector>
#include "action_plan.h"
#include "base/file_status.h"
#include "glare/columns.h"
#include "options.h"
#include "stopping.h"

struct RunPlan {
    glare::SharedPlan measured;
    std::vector<glare::Column> columns;
    size_t ordinary = 0;            // as many columns are those of ordinary pictures; behind them: of actions
    std::vector<std::string> keys;  // of these: what can be compared from edit to edit has the same one
    ActionPlan actions;
    StopRule rule;
    std::vector<glare::ContrastPair> pairs;
    bool needs_looks = false, reports = false;  // intervals are shown or serve a rule; why there are none
    int64_t first_look = 0;                     // frames

    base::FileStamp version;  // of the region file
    int reading = 0;          // counts those that gave a plan
    bool again = false;       // it was read once more
    bool waits = false;       // it has changed, but may still be being written; the regions before are measured
};
RunPlan plan_run(const Options& options);
std::vector<glare::Column> ordinary_columns(const RunPlan& plan);

// Throws Error where a region of -cr is not there, as it may be in a live stream.
void require_pairs(const RunPlan& plan);
// Called before a picture of a live stream.  An error in a changed region file is reported once; the regions and
// columns stay.
RunPlan with_present_regions(const Options& options, RunPlan plan);
