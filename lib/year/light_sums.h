// SPDX-License-Identifier: BSD-3-Clause
// Light of several runs added up at sensors, with the errors that they have in common: frames of one seed are alike,
// and half-samples of a sum are sums of half-samples.
#pragma once
#include <utility>
#include <vector>

#include "year/table.h"

namespace year {

// The hours, times their factors.  Errors of hours without half-samples count as if all had the same sign.
GridHour sum_of(const std::vector<std::pair<double, const GridHour*>>& hours);

}  // namespace year
