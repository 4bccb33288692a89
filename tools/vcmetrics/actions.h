// SPDX-License-Identifier: BSD-3-Clause
// Pictures of actions in a run (action_plan.h): each belongs to the ordinary picture of the same view, sky, state and
// hour before it, whose numbers stand in its rows, so that the last row of a view has them all.
#pragma once
#include <optional>
#include <utility>
#include "run.h"

// With a picture that comes, which may begin another group.  Throws Error for one of an action by itself in which
// nothing is measured: its illuminance is no Ev.
Group with_picture(const RunPlan& plan, Group group, const image::Header& header, const PicturePlace& place);
// Is nothing measured in it?  A picture of V by itself, whose numbers are luminances, is measured as an ordinary one.
bool is_passed_over(const RunPlan& plan, const Group& group, const image::Header& header, const PicturePlace& place);
// After the last picture of a group, and of the run: what its columns lack.
Group end_group(const RunPlan& plan, Group group, bool ends);

// With an ordinary picture's row, which gets the cells of actions.
Row with_actions(const Options& options, const RunState& run, const image::Header& header, Row row);
// The step of an action's picture (run.h).
std::pair<RunState, std::optional<Row>> step_of_action(const Options& options, RunState run, size_t kind,
                                                       image::Picture& picture, const PicturePlace& place);

// Does the rule hold, and does the run end?  kind: none of an ordinary picture.
std::pair<Progress, Verdict> judge(const Options& options, const RunState& run, std::optional<size_t> kind,
                                   MeasuredSum sum, bool looked);
