// SPDX-License-Identifier: BSD-3-Clause
// Names and patterns: * stands for any letters, ? for one.  (near_matches() is declared in region.h.)
#pragma once
#include <string>

namespace region {
bool matches(const std::string& pattern, const std::string& name);
}  // namespace region
