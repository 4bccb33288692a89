// SPDX-License-Identifier: BSD-3-Clause
// The hours of -wea from one set of paths (render/hours.h).
#pragma once
#include <string>
#include "options.h"
#include "render/session.h"
#include "report.h"

// Empty, or why these hours are rendered one by one.
std::string why_apart(const Options& opt);

// All hours of view i, which the session has selected: dark ones as black frames.
void render_hours(Options opt, size_t i, const render::Session& session, Report& report);
