// SPDX-License-Identifier: BSD-3-Clause
// The syntax is checked here, character by character; std::from_chars does the rounding (fast and without a locale).
#include "base/number.h"
#include <charconv>
#include <cstddef>

namespace base {

static bool digit(char c) { return c >= '0' && c <= '9'; }

bool parse_integer(std::string_view word, long long& value) {
    size_t i = !word.empty() && (word[0] == '+' || word[0] == '-');
    if (i == word.size()) return false;
    for (size_t k = i; k < word.size(); k++)
        if (!digit(word[k])) return false;
    const char* first = word.data() + (word[0] == '+');
    return std::from_chars(first, word.data() + word.size(), value).ec == std::errc();
}

bool parse_real(std::string_view word, double& value) {
    const size_t n = word.size();
    size_t i = n && (word[0] == '+' || word[0] == '-');
    size_t digits = 0;
    while (i < n && digit(word[i])) i++, digits++;
    if (i < n && word[i] == '.')
        for (i++; i < n && digit(word[i]); i++) digits++;
    if (!digits) return false;
    bool small = false;
    if (i < n && (word[i] == 'e' || word[i] == 'E')) {
        if (++i < n && (word[i] == '+' || word[i] == '-')) small = word[i++] == '-';
        if (i == n || !digit(word[i])) return false;
        while (i < n && digit(word[i])) i++;
    }
    if (i != n) return false;
    const std::errc ec = std::from_chars(word.data() + (word[0] == '+'), word.data() + n, value).ec;
    if (ec == std::errc()) return true;
    if (ec != std::errc::result_out_of_range || !small) return false;
    value = 0;
    return true;
}

}  // namespace base
