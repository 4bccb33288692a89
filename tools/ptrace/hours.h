// SPDX-License-Identifier: BSD-3-Clause
// The hours of -wea from one set of paths (render/hours.h).
#pragma once
#include <vector>
#include "options.h"
#include "render/view_plan.h"
#include "report.h"

// The renderings of an action, in place of the ordinary ones.
struct ActionHours {
    image::Action label;
    std::vector<render::ActionPart> parts;  // by daylight
    std::vector<render::ViewPlan> plans;
};

// All hours of view i, dark ones as black frames, but those that are better rendered by themselves (have_images()):
// of each sky, whether it is left.  action: null, or theirs; plan: with the fingerprint of all then.
std::vector<bool> render_hours(Options opt, size_t i, device::Device& device, const render::ViewPlan& plan,
                               Report& report, const ActionHours* action = nullptr);
