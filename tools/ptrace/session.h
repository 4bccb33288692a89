// SPDX-License-Identifier: BSD-3-Clause
// What a run renders, and how it follows edits: a change of the run (edits.h) becomes a plan of the picture, or is said
// to have failed and leaves what was there.
#pragma once
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "base/progress.h"
#include "edits.h"
#include "render/control.h"
#include "render/setup.h"
#include "report.h"

struct Session {
    explicit Session(Options options);

    Run run;
    render::Control control;
    Report report;
    std::unique_ptr<device::Device> device;
    render::SceneText text;
    render::ViewPlan plan;
    std::vector<std::vector<render::ViewPlan>> action_plans;  // of the parts of each action
    std::set<size_t> eyes_looked_at;                          // pictures whose eye was asked whether it is odd
    std::string failure;  // of the files as they are now; empty: they are what is rendered
};

// Setup of picture i.
render::Setup setup_of(const Options& opt, size_t i, base::Progress& progress);

// A file of regions is drawn for each view; masks are of one size.
void choose_focus(Options& opt);

// Plans picture i under this sky, after these commands and those that come meanwhile.  Returns true if it begins anew.
// What cannot be carried out is said, and all else goes on as before.
bool carry_out(Session& session, std::vector<render::Command> commands, const Sky& sky, size_t i);
// The same without a command; throws Error.  The scene is loaded.
void plan_first(Session& session, const Sky& sky, size_t i);

// "what x y": one line, with the words of the question, the number of the edit and what is there (render/seen.h).
void answer_what(const Session& session, const std::string& rest);
