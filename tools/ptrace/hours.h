// SPDX-License-Identifier: BSD-3-Clause
// The hours of -wea from one set of paths (render/hours.h).
#pragma once
#include <vector>
#include "options.h"
#include "render/action.h"
#include "report.h"

// All hours of view i, dark ones as black frames, but those that are better rendered by themselves (have_images()):
// of each sky, whether it is left.  Behind the frames of an hour those of each action.
std::vector<bool> render_hours(Options opt, size_t i, device::Device& device, const render::ViewPlan& plan,
                               Report& report, const std::vector<render::ActionHours>& actions);
