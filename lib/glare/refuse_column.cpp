// SPDX-License-Identifier: BSD-3-Clause
// See refuse_column.h.
#include "glare/refuse_column.h"

#include <algorithm>

#include "base/edit_distance.h"
#include "base/error.h"
#include "glare/columns.h"

namespace glare {
namespace {

std::string listed(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& word : words) out += (out.empty() ? "" : ", ") + word;
    return out;
}

bool is_in(const std::vector<std::string>& words, const std::string& word) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

void refuse_column(const std::string& name, const std::vector<std::string>& regions,
                   const std::vector<std::string>& of_regions, const std::vector<std::string>& names) {
    const size_t dot = name.rfind('.');
    const std::string of = name.substr(0, dot);
    if (dot != std::string::npos && !is_in(names, of) && regions.empty())
        base::fail("-metrics", name + " needs regions (-regions file), or a picture of points (ptrace -points)");
    if (dot != std::string::npos && is_in(regions, of))
        base::fail("-metrics", name + ": a region has " + listed(of_regions));
    if (dot != std::string::npos && !is_in(names, of))
        base::fail("-metrics", name + ": there is no region \"" + of + "\"; there are " + listed(regions));
    const std::string question = base::question(name, names);
    base::fail("-metrics",
               "there is no metric \"" + name + "\"" + (question.empty() ? "; there are " + column_names() : question));
}

}  // namespace glare
