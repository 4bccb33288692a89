// SPDX-License-Identifier: BSD-3-Clause
// Hours that a table of vcmetrics has, so that a run that was cut off goes on with the others (ptrace -after).
#pragma once
#include <map>
#include <set>
#include <string>
#include <utility>

namespace weather {

// Names of hours, by the view and the state of the scene; "" where the table has no such column.
using Rendered = std::map<std::pair<std::string, std::string>, std::set<std::string>>;

// Of points an hour counts whose rows are all there.  Throws Error (place: the file, and the line) where it is no table
// of hours, or ends within a line.
void read_rendered(const std::string& path, Rendered& all);

}  // namespace weather
