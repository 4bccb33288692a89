// SPDX-License-Identifier: BSD-3-Clause
// Commands of -control that change what is rendered.
#pragma once
#include "options.h"
#include "render/control.h"

// Does it ask for the scene's files?
inline bool reads_files(const render::Command& c) { return c.word == "scene" || c.word == "overlay"; }

// Carries out a command on the options; picture: of opt.views, the one at hand.  Throws Error for what is no command,
// with the options as they were.
void edit(const render::Command& command, size_t picture, Options& opt);
