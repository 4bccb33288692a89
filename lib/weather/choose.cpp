// SPDX-License-Identifier: BSD-3-Clause
// See choose.h.
#include "weather/choose.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "weather/day_rule.h"
#include "weather/schedule.h"

namespace weather {
namespace {

constexpr const char* option = "-hours";

struct Span {
    double from, to;
    bool holds(double x) const { return from <= to ? x >= from && x < to : x >= from || x < to; }
};

// "8", "8:30"
std::optional<double> clock_hour(const std::string& text) {
    const size_t colon = text.find(':');
    long long h = 0, m = 0;
    if (!base::parse_integer(text.substr(0, colon), h) || h < 0 || h > 24) return std::nullopt;
    if (colon != std::string::npos && (!base::parse_integer(text.substr(colon + 1), m) || m < 0 || m > 59))
        return std::nullopt;
    return double(h) + double(m) / 60;
}

// "29Mar", or "0329" as in names of hours.
std::optional<Date> date_named(const std::string& text) {
    if (const auto t = parse_name(text)) return t->date;
    const size_t letters = std::min(text.find_first_not_of("0123456789"), text.size());
    long long day = 0;
    const auto month = month_named(text.substr(letters));
    if (!month || !base::parse_integer(text.substr(0, letters), day) || !is_date(*month + 1, int(day)))
        return std::nullopt;
    return Date{*month + 1, int(day)};
}

constexpr const char* separators = " \t\r\n,";

// Blanks and commas part words, but not those of a path: of "@my hours,1.csv 8-18" the longest file that is there.
std::vector<std::string> words_of(const std::string& text) {
    std::vector<std::string> words;
    for (size_t at = text.find_first_not_of(separators); at < text.size();
         at = text.find_first_not_of(separators, at)) {
        const size_t first_end = std::min(text.find_first_of(separators, at), text.size());
        size_t end = text[at] == '@' ? text.size() : first_end;
        std::error_code absent;
        while (end > first_end && !std::filesystem::exists(text.substr(at + 1, end - at - 1), absent))
            end = std::max(first_end, text.find_last_of(separators, end - 1));
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

class HourWords {
public:
    HourWords(const Weather& w, std::optional<double> used_from)
        : weather_(w), used_from_(used_from), first_weekday_(w.first_weekday) {
        leap_ = std::any_of(w.hours.begin(), w.hours.end(),
                            [](const Hour& h) { return h.time.date.in_leap_year() == leap_day; });
    }
    void read(const std::string& word) {
        if (word[0] == '@') {
            Schedule s = read_schedule(word.substr(1), weather_, used_from_);
            if (s.minutes.empty()) return schedules_.push_back(std::move(s));
            minutes_.insert(s.minutes.begin(), s.minutes.end());
            by_name_ = by_name_ || s.by_name;
            return;
        }
        if (word == "all") return;
        if (word == "dst" || base::begins_with(word, "dst=")) return read_summer_time(word);
        if (const size_t slash = word.find('/'); slash != std::string::npos) return read_share(word, slash);
        const size_t dash = word.find('-');
        const bool known =
            dash == std::string::npos ? read_name(word) : read_span(word.substr(0, dash), word.substr(dash + 1));
        if (const auto time = clock_hour(word); !known && time && *time < 24)
            base::fail(option, fmt::format("\"{0}\" is a moment; hours are a span, as {0}-{1}", word,
                                           std::to_string(int(*time) + 1) +
                                               word.substr(std::min(word.find(':'), word.size()))));
        if (!known)
            base::fail(option,
                       "\"" + base::excerpt(word) +
                           "\" is no day (Mo-Fr), month (Jun), time (8-18), date (21Jun), share (3/16) or @file");
    }
    // When all words are read.
    void finish() {
        if (!summer_[0]) return;
        const auto day = [&](const DayRule& rule) { return double(rule.date(first_weekday_, leap_).in_leap_year()); };
        summer_days_ = {day(*summer_[0]), day(*summer_[1])};
    }
    // By the clock, but for names, which are in standard time.
    bool uses(const Hour& h) const {
        int day = h.time.date.in_leap_year();
        double hour = h.time.hour;
        if (summer_[0] && summer_days_.holds(day)) hour += 1;
        if (hour >= 24) {
            hour -= 24;
            day = day == 366 ? 1 : day + 1;
            if (day == leap_day && !leap_) ++day;
        }
        const Date date = date_of(day);
        const int weekday = (first_weekday_ + (leap_ ? day : date.of_year()) - 1) % 7;
        const auto in = [](const std::vector<Span>& spans, double x) {
            return spans.empty() || std::any_of(spans.begin(), spans.end(), [&](const Span& s) { return s.holds(x); });
        };
        return in(weekdays_, weekday) && in(months_, date.month - 1) && in(days_, day) && in(hours_, hour + 1e-6) &&
               (minutes_.empty() || minutes_.count(h.time.minute_of_year())) &&
               std::all_of(schedules_.begin(), schedules_.end(),
                           [&](const Schedule& s) { return s.used[size_t(24 * (day - 1) + int(hour + 1e-6))]; });
    }
    bool names(const Hour& hour) const { return named_.count(hour.time.minute_of_year()) > 0; }
    // Of n hours: the first of the share, and the one behind its last.
    size_t share_begins(size_t n) const { return (part_ - 1) * n / parts_; }
    size_t share_ends(size_t n) const { return part_ * n / parts_; }
    std::string note() const {
        std::string text = fmt::format("1 January is a {}, standard time is UTC{:+g}", weekday_name(first_weekday_),
                                       -weather_.meridian_deg / 15 + 0.);
        if (summer_[0])
            text += fmt::format(", the clock is an hour ahead from {} to {}", day_text(date_of(int(summer_days_.from))),
                                day_text(date_of(int(summer_days_.to))));
        return text;
    }
    int year() const { return year_; }
    bool by_name() const { return by_name_; }

private:
    // A span has its last name in it, but for hours of the clock, which are times.
    bool read_span(const std::string& from, const std::string& to) {
        const auto add = [](std::vector<Span>& spans, double a, double b, double size) {
            spans.push_back(b + 1 == a ? Span{0, size + 1} : Span{a, b + 1});  // "We-Tu" is every day
            return true;
        };
        if (const auto a = weekday_named(from), b = weekday_named(to); a && b) return add(weekdays_, *a, *b, 7);
        if (const auto a = month_named(from), b = month_named(to); a && b) return add(months_, *a, *b, 12);
        if (const auto a = date_named(from), b = date_named(to); a && b)
            return add(days_, a->in_leap_year(), b->in_leap_year(), 366);
        const auto a = clock_hour(from), b = clock_hour(to);
        if (a && b && *a != *b) hours_.push_back({*a, *b});
        return a && b && *a != *b;
    }
    bool read_name(const std::string& word) {
        if (weekday_named(word) || month_named(word)) return read_span(word, word);
        if (const auto t = parse_name(word); t && t->hour >= 0) {
            const auto minute = weather_.minute_named(*t);
            if (!minute) base::fail(option, word + " is not an hour of " + weather_.path);
            minutes_.insert(*minute);
            named_.insert(*minute);
            by_name_ = true;
            return true;
        }
        if (date_named(word)) return read_span(word, word);
        long long year = 0;
        if (!base::parse_integer(word, year) || year < 1900 || year > 2999) return false;
        year_ = int(year);
        first_weekday_ = weekday_of_1_january(year_);
        leap_ = year % 4 == 0 && (year % 100 != 0 || year % 400 == 0);
        return true;
    }
    void read_summer_time(const std::string& word) {
        if (word == "dst") {
            const std::string& from = weather_.summer_time[0];
            if (from.empty())
                base::fail(option, weather_.path + " states no daylight saving; say its dates: dst=29Mar-25Oct");
            for (int k : {0, 1}) {
                const std::string& text = weather_.summer_time[k];
                summer_[k] = parse_day_rule(text);
                if (!summer_[k])
                    base::fail(option, weather_.path + ": daylight saving: \"" + base::excerpt(text) +
                                           "\" is no date; say its dates: dst=29Mar-25Oct");
            }
            return;
        }
        const size_t dash = word.find('-');
        const auto from = date_named(word.substr(4, dash - 4));
        const auto to = dash == std::string::npos ? std::nullopt : date_named(word.substr(dash + 1));
        if (!from || !to) base::fail(option, "\"" + base::excerpt(word) + "\" is not like dst=29Mar-25Oct");
        summer_[0] = DayRule{from->month, from->day}, summer_[1] = DayRule{to->month, to->day};
    }
    void read_share(const std::string& word, size_t slash) {
        long long part = 0, parts = 0;
        if (!base::parse_integer(word.substr(0, slash), part) || !base::parse_integer(word.substr(slash + 1), parts) ||
            part < 1 || part > parts || parts > 1000000)
            base::fail(option, "\"" + base::excerpt(word) + "\" is not a share such as 3/16");
        part_ = size_t(part), parts_ = size_t(parts);
    }

    const Weather& weather_;
    std::optional<double> used_from_;
    std::vector<Span> weekdays_, months_, hours_, days_;
    std::set<int> minutes_, named_;  // of hours in files and by name; by name alone
    std::optional<DayRule> summer_[2];
    std::vector<Schedule> schedules_;
    int first_weekday_, year_ = 0;
    bool leap_ = false, by_name_ = false;
    Span summer_days_{0, 0};
    size_t part_ = 1, parts_ = 1;
};

}  // namespace

Choice choose_hours(const Weather& w, const std::string& words, std::optional<double> used_from) {
    HourWords rules(w, used_from);
    for (const std::string& word : words_of(words)) rules.read(word);
    rules.finish();
    Choice c;
    for (size_t i = 0; i < w.hours.size(); ++i)
        if (rules.uses(w.hours[i])) c.hours.push_back(i);
    if (c.hours.empty()) base::fail(option, "\"" + base::excerpt(words) + "\" means no hour of " + w.path);
    c.note = rules.note();
    c.year = rules.year();
    c.by_name = rules.by_name();
    c.whole = c.hours.size();
    c.first = rules.share_begins(c.whole);
    c.hours = {c.hours.begin() + long(c.first), c.hours.begin() + long(rules.share_ends(c.whole))};
    for (const size_t i : c.hours)
        if (rules.names(w.hours[i])) c.named.insert(i);
    return c;
}

}  // namespace weather
