// SPDX-License-Identifier: BSD-3-Clause
// The pictures of -action: behind the ordinary frames of a view those of each action.
#pragma once
#include <cstddef>

#include "hours.h"
#include "session.h"

// Warns once of what has no spectrum; the scene is loaded.
void warn_of_guesses(const Session& session);
// Says once what spectra a sky gets by -daylight sky; of hours, all of them with the first one.
void tell_daylight(const Session& session, const Sky& sky, bool is_first);

// Plans the renderings of action a of view i, and returns how they add up.
std::vector<render::ActionPart> plan_action(Session& session, size_t a, size_t i);
// View i under this sky, by each action.  Returns false where an edit came.
bool render_actions(Session& session, const Sky& sky, size_t i);
// Their renderings of hours of -wea that share their paths.
std::vector<render::ActionHours> plan_action_hours(Session& session, size_t i);
// The same in a dark hour.
void write_dark_actions(const Options& opt, image::Picture& picture);
