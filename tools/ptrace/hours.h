// SPDX-License-Identifier: BSD-3-Clause
// The hours of -wea from one set of paths (render/hours.h).
#pragma once
#include <string>
#include "options.h"
#include "render/view_plan.h"
#include "report.h"

// All hours of view i: dark ones as black frames.
void render_hours(Options opt, size_t i, device::Device& device, const render::ViewPlan& plan, Report& report);
