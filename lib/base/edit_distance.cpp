// SPDX-License-Identifier: BSD-3-Clause
// See edit_distance.h.
#include "base/edit_distance.h"

#include <algorithm>
#include <cctype>
#include <vector>

namespace base {

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

std::string meant_by(const std::string& word, const std::vector<std::string>& list) {
    const auto small = [](std::string text) {
        for (char& c : text) c = char(std::tolower(static_cast<unsigned char>(c)));
        return text;
    };
    std::string meant;
    int best = largest_slip(word.size()) + 1;
    for (const std::string& other : list)
        if (const int d = edit_distance(small(word), small(other)); d < best) best = d, meant = other;
    return meant;
}

std::string question(const std::string& word, const std::vector<std::string>& list) {
    const std::string meant = meant_by(word, list);
    return meant.empty() ? "" : "; did you mean " + meant + "?";
}

}  // namespace base
