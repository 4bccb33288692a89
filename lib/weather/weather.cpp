// SPDX-License-Identifier: BSD-3-Clause
// Finds the format, reads its lines, and checks in both formats the order of hours and that none comes twice.
#include "weather/weather.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/text_file.h"
#include "weather/lines.h"

namespace weather {

constexpr size_t longest_line = size_t(1) << 16;  // EPW's comments may be long
constexpr size_t most_hours = 366 * 1440;         // a line a minute

Lines::Lines(const std::string& path) : in_(base::TextReader::from_file(path, "")) {}

bool Lines::next() {
    do {
        line_ = in_.line();
        if (!in_.line(text_, longest_line)) return false;
        if (line_ == 1 && base::begins_with(text_, base::byte_order_mark)) text_.erase(0, base::byte_order_mark.size());
        text_.erase(text_.find_last_not_of(" \t\r") + 1);
    } while (text_.empty());
    return true;
}

void Lines::split(char separator) {
    fields_.clear();
    if (separator == ' ') {
        fields_ = base::split_words(text_);
        return;
    }
    for (size_t at = 0; at <= text_.size();) {
        size_t from = std::min(text_.find_first_not_of(" \t", at), text_.size()), end = text_.find(separator, at);
        std::string quoted;
        if (from < text_.size() && text_[from] == '"') {
            for (++from; from < text_.size() && (text_[from] != '"' || text_[++from] == '"'); ++from)
                quoted += text_[from];
            end = text_.find(separator, from);
        }
        end = std::min(end, text_.size());
        const size_t last = text_.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
        if (from < end && last >= from) quoted.append(text_, from, last + 1 - from);
        fields_.push_back(std::move(quoted));
        at = end + 1;
    }
}

void Lines::fail(const std::string& fact) const { base::fail(in_.name() + ":" + std::to_string(line_), fact); }

const std::string& Lines::field(size_t i, const char* what) const {
    if (i >= fields_.size()) fail(std::string(what) + " is missing");
    return fields_[i];
}

double Lines::number(size_t i, const char* what) const {
    double v = 0;
    if (!base::parse_real(field(i, what), v))
        fail(fmt::format("{}: \"{}\" is not a number", what, base::excerpt(fields_[i])));
    return v;
}

double Lines::number_or_nan(size_t i, const char* what) const { return field(i, what).empty() ? NAN : number(i, what); }

double Lines::number(size_t i, const char* what, double low, double high) const {
    const double v = number(i, what);
    if (v < low || v > high) fail(fmt::format("{} {:g} is not between {:g} and {:g}", what, v, low, high));
    return v;
}

int Lines::whole(size_t i, const char* what, int low, int high) const {
    const double v = number(i, what, low, high);
    if (v != std::floor(v)) fail(fmt::format("{} {:g} is not a whole number", what, v));
    return int(v);
}

void add_hour(const Lines& in, Hour hour, Weather& w) {
    if (w.hours.size() == most_hours) in.fail("more lines than a year has minutes");
    if (!is_date(hour.time.date.month, hour.time.date.day)) in.fail("this month has fewer days");
    hour.line = in.line();
    w.hours.push_back(hour);
}

// West is positive in one format and east in the other: a sign that is lost puts the sun on the other side.  Zones are
// quarters of an hour; others are those of solar time, whose meridian is the longitude, to a digit of an hour.
static void require_zone(const Weather& w) {
    constexpr double pole_deg = 89, apart_deg = 75, quarter_deg = 3.75, digit_deg = .76;
    if (std::fabs(w.latitude_deg) > pole_deg) return;
    const double off = std::remainder(w.longitude_deg - w.meridian_deg, 360);
    const bool is_solar = std::fabs(std::remainder(w.meridian_deg, quarter_deg)) > .02;
    if (std::fabs(off) <= (is_solar ? digit_deg : apart_deg)) return;
    std::string text = fmt::format("the longitude {:g} west and the time zone of {:g} west do not go together",
                                   w.longitude_deg, w.meridian_deg);
    if (is_solar) text += ": one that is no quarter of an hour is that of solar time, whose meridian is the longitude";
    if (std::fabs(std::remainder(w.longitude_deg + w.meridian_deg, 360)) < (is_solar ? digit_deg : std::fabs(off)))
        text += fmt::format("; is the sign of one of them wrong ({:g} and {:g})?", w.longitude_deg, -w.meridian_deg);
    base::fail(w.path, text);
}

std::optional<int> Weather::minute_named(const Time& name) const {
    const int wanted = name.minute_of_year();
    auto h = std::lower_bound(hours.begin(), hours.end(), wanted - 1,
                              [](const Hour& a, int minute) { return a.time.minute_of_year() < minute; });
    std::vector<int> near;
    for (; h != hours.end() && h->time.minute_of_year() <= wanted + 1; ++h) near.push_back(h->time.minute_of_year());
    if (std::find(near.begin(), near.end(), wanted) != near.end()) return wanted;
    if (near.size() != 1) return std::nullopt;
    return near[0];
}

Weather read_weather(const std::string& path) {
    std::error_code absent;
    if (std::filesystem::is_directory(path, absent))
        base::fail(path, "is a folder; a file of weather is needed, EPW or WEA");
    Lines in(path);
    Weather w;
    w.path = path;
    if (!in.next()) base::fail(path, "is empty");
    if (is_epw(in)) read_epw(in, w);
    else if (base::begins_with(in.text(), "place ")) read_wea(in, w);
    else base::fail(path, "is neither EPW (LOCATION, ...) nor WEA (place ...)");
    if (w.hours.empty()) base::fail(path, "has no hours");
    require_zone(w);
    const auto minute = [](const Hour& h) { return h.time.minute_of_year(); };
    std::stable_sort(w.hours.begin(), w.hours.end(),
                     [&](const Hour& a, const Hour& b) { return minute(a) < minute(b); });
    for (size_t i = 1; i < w.hours.size(); ++i)
        if (minute(w.hours[i]) == minute(w.hours[i - 1]))
            base::fail(w.place_of(w.hours[i]), fmt::format("the hour {} was in line {} already",
                                                           name_of(w.hours[i].time), w.hours[i - 1].line));
    return w;
}

}  // namespace weather
