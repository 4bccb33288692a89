// SPDX-License-Identifier: BSD-3-Clause
// The numbers of states that a dynamic schedule of honeybee-radiance-postprocess (a .json file) has for a group: under
// the group's name a list, or an object whose "schedule" is a list.
#pragma once
#include <optional>
#include <string>
#include <vector>

namespace year {

// Nothing for a file of another kind.  Throws Error (place: the file) where it has no list for the group, or where this
// is not of whole numbers.
std::optional<std::vector<size_t>> read_honeybee_schedule(const std::string& path, const std::string& group);

}  // namespace year
