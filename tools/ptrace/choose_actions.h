// SPDX-License-Identifier: BSD-3-Clause
// The spectra that -action, -daylight and -lamp name.
#pragma once
#include "options.h"

// Throws Error where they do not go together.
void choose_actions(Options& opt);
