// SPDX-License-Identifier: BSD-3-Clause
// -difference: what each metric of the second input is above that of the first, with its interval; or, with -tolerance,
// whether it is within that: status 0 when all are, 5 when not.
#pragma once
#include "options.h"

int difference_inputs(const Options& options);  // exit status
