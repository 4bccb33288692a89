// SPDX-License-Identifier: BSD-3-Clause
// -spectrum: what a light is to the five actions of CIE S 026, beside its illuminance.
#pragma once
#include "options.h"

// A row a light, with the daylight (D65) efficacy ratio by each action; 1 for D65.  Returns the exit status.
int print_spectra(const Options& options);
