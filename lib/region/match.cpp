// SPDX-License-Identifier: BSD-3-Clause
// Wildcards, and the "did you mean" of names that do not exist.
#include <algorithm>
#include <cctype>

#include "base/edit_distance.h"
#include "region/region.h"

namespace region {

bool matches(const std::string& pattern, const std::string& name) {
    size_t p = 0, n = 0, star = std::string::npos, resume = 0;
    while (n < name.size()) {
        if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            resume = n;
        } else if (p < pattern.size() && (pattern[p] == '?' || pattern[p] == name[n])) {
            ++p;
            ++n;
        } else if (star != std::string::npos) {  // let the last * take one letter more
            p = star + 1;
            n = ++resume;
        } else {
            return false;
        }
    }
    while (p < pattern.size() && pattern[p] == '*') ++p;
    return p == pattern.size();
}

std::string near_matches(const std::string& name, const std::vector<std::string>& names) {
    auto lower = [](std::string s) {
        for (char& c : s) c = char(std::tolower((unsigned char)c));
        return s;
    };
    std::string wanted = lower(name);
    wanted.erase(std::remove(wanted.begin(), wanted.end(), '*'), wanted.end());
    if (wanted.empty() || wanted.size() > 200) return "";
    std::vector<std::pair<int, std::string>> good;
    for (const std::string& candidate : names) {
        if (candidate.size() > 200) continue;
        std::string other = lower(candidate);
        int d = base::edit_distance(wanted, other);
        if (other.find(wanted) != std::string::npos || (other.size() > 2 && wanted.find(other) != std::string::npos))
            d = std::min(d, 1);
        if (d <= base::largest_slip(wanted.size())) good.emplace_back(d, candidate);
    }
    std::sort(good.begin(), good.end());
    good.erase(std::unique(good.begin(), good.end()), good.end());
    if (good.size() > 3) good.resize(3);
    std::string text;
    for (size_t i = 0; i < good.size(); ++i)
        text += (i == 0 ? " (did you mean \"" : i + 1 < good.size() ? ", \"" : " or \"") + good[i].second + "\"";
    return text.empty() ? text : text + "?)";
}

}  // namespace region
