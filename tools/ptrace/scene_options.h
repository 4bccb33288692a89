// SPDX-License-Identifier: BSD-3-Clause
// What a scene's own file (the render=, rpict= and view= of a rad input file, and the @files they name) may ask for:
// how light is followed and from where it is seen.  Programs, files to write, devices, frames and messages are the
// user's.
// The list below is the only place that decides it; docs/security.md tells the rest.
#pragma once
#include <string>

#include "base/radopts.h"

// Throws Error (place = file) for an option that is not the scene's to give.  The word itself may come from any file
// that an @file names, so only its first letters are shown.
void require_scene_option(const std::string& word, const std::string& file);

// rpict's -t and -w, at the cursor: harmless, often there, and the user's: stepped over.
bool skip_callers_option(base::Words& words);
