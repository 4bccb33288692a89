// SPDX-License-Identifier: BSD-3-Clause
// The message for a name of -metrics that is no column: what may be meant, or is missing.
#pragma once
#include <string>
#include <vector>

namespace glare {

// regions: of the run; of_regions: what a region has (TAL, mean); names: all columns of pictures.  Throws Error.
[[noreturn]] void refuse_column(const std::string& name, const std::vector<std::string>& regions,
                                const std::vector<std::string>& of_regions, const std::vector<std::string>& names);

}  // namespace glare
