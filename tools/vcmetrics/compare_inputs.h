// SPDX-License-Identifier: BSD-3-Clause
// -compare: two inputs, metric by metric.  Status 0 when all are within tolerance, 5 when not; a metric or row that
// one side lacks is an Error (1).
#pragma once
#include "options.h"

int compare_inputs(const Options& options);
