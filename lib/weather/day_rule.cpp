// SPDX-License-Identifier: BSD-3-Clause
// See day_rule.h.
#include "weather/day_rule.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/number.h"

namespace weather {
namespace {

// Runs of digits and runs of letters: "29-Mar" is 29, mar; "2nd" is 2, nd.
std::vector<std::string> tokens(const std::string& text) {
    std::vector<std::string> all;
    int kind = 0;
    for (const char c : text) {
        const auto u = static_cast<unsigned char>(c);
        const int now = std::isdigit(u) ? 1 : std::isalpha(u) ? 2 : 0;
        if (now != kind && now != 0) all.emplace_back();
        if (now != 0) all.back() += char(std::tolower(u));
        kind = now;
    }
    return all;
}

std::optional<int> which_named(const std::string& word) {
    static const char* const names[] = {"first", "second", "third", "fourth", "last"};
    for (int k = 0; k < 5; ++k)
        if (word == names[k]) return k + 1;
    return std::nullopt;
}

std::optional<DayRule> fixed(long long month, long long day) {
    if (month < 1 || month > 12 || day < 1 || day > 31 || !is_date(int(month), int(day))) return std::nullopt;
    return DayRule{int(month), int(day), 0, 1};
}

// "2 nd sunday in march", "last sunday in october"; `in` and the ending of the number may be missing.
std::optional<DayRule> by_weekday(std::vector<std::string> words) {
    long long n = 0;
    DayRule rule;
    if (const auto named = which_named(words[0])) rule.which = *named;
    else if (base::parse_integer(words[0], n) && n >= 1 && n <= 5) rule.which = int(n);
    else return std::nullopt;
    const auto is_filler = [](const std::string& w) {
        return w == "st" || w == "nd" || w == "rd" || w == "th" || w == "in" || w == "of";
    };
    words.erase(std::remove_if(words.begin() + 1, words.end(), is_filler), words.end());
    if (words.size() != 3) return std::nullopt;
    const auto weekday = weekday_named(words[1]), month = month_named(words[2]);
    if (!weekday || !month) return std::nullopt;
    rule.weekday = *weekday, rule.month = *month + 1;
    return rule;
}

}  // namespace

Date DayRule::date(int first_weekday, bool leap_year) const {
    if (day > 0) return {month, day};
    const auto days_before = [&](const Date& d) { return (leap_year ? d.in_leap_year() : d.of_year()) - 1; };
    const auto weekday_of = [&](const Date& d) { return (first_weekday + days_before(d)) % 7; };
    Date d{month, 1 + (weekday - weekday_of({month, 1}) + 7) % 7};
    const auto is_day = [&](int k) { return is_date(month, k) && (leap_year || month != 2 || k != 29); };
    for (int k = 1; k < which && is_day(d.day + 7); ++k) d.day += 7;
    return d;
}

std::optional<DayRule> parse_day_rule(const std::string& text) {
    const std::vector<std::string> words = tokens(text);
    long long a = 0, b = 0;
    if (words.size() == 2 && base::parse_integer(words[0], a) && base::parse_integer(words[1], b)) return fixed(a, b);
    if (words.size() == 2 && base::parse_integer(words[0], a))
        if (const auto month = month_named(words[1])) return fixed(*month + 1, a);
    if (words.size() == 2 && base::parse_integer(words[1], b))
        if (const auto month = month_named(words[0])) return fixed(*month + 1, b);
    return words.size() >= 3 ? by_weekday(words) : std::nullopt;
}

}  // namespace weather
