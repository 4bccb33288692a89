// SPDX-License-Identifier: BSD-3-Clause
// Wildcards, and the "did you mean" of names that do not exist: Damerau's edit distance, restricted form
// (F. J. Damerau, CACM 7(3), 1964).
#include "region/match.h"
#include <algorithm>
#include <cctype>
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

int edit_distance(const std::string& a, const std::string& b) {
    std::vector<int> before(b.size() + 1), above(b.size() + 1), row(b.size() + 1);
    for (size_t j = 0; j <= b.size(); ++j) above[j] = int(j);
    for (size_t i = 1; i <= a.size(); ++i) {
        row[0] = int(i);
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
        before.swap(above);
        above.swap(row);
    }
    return above[b.size()];
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
        int d = edit_distance(wanted, other);
        if (other.find(wanted) != std::string::npos || (other.size() > 2 && wanted.find(other) != std::string::npos))
            d = std::min(d, 1);
        if (d <= std::max(1, int(wanted.size()) / 3)) good.emplace_back(d, candidate);
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
