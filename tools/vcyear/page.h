// SPDX-License-Identifier: BSD-3-Clause
// The page of vcyear -report from what its options name.
#pragma once
#include <vector>

#include "shaded.h"
#include "year/page.h"

year::Page page_of(const Options& options, const Counted& counted, const std::vector<year::Verdict>& verdicts,
                   const std::vector<year::BodyClock>& clocks);
