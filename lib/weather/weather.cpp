// SPDX-License-Identifier: BSD-3-Clause
// Finds the format, reads its lines, and checks in both formats the order of hours and that none comes twice.
#include "weather/weather.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

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
        const size_t end = std::min(text_.find(separator, at), text_.size());
        const size_t from = std::min(text_.find_first_not_of(" \t", at), end);
        const size_t last = text_.find_last_not_of(" \t", end == 0 ? 0 : end - 1);
        fields_.push_back(from < end ? text_.substr(from, last + 1 - from) : "");
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

Weather read_weather(const std::string& path) {
    Lines in(path);
    Weather w;
    w.path = path;
    if (!in.next()) base::fail(path, "is empty");
    if (base::begins_with(in.text(), "LOCATION,")) read_epw(in, w);
    else if (base::begins_with(in.text(), "place ")) read_wea(in, w);
    else base::fail(path, "is neither EPW (LOCATION, ...) nor WEA (place ...)");
    if (w.hours.empty()) base::fail(path, "has no hours");
    // West is positive in one format and east in the other: a sign that is lost puts the sun on the other side.
    if (std::fabs(std::remainder(w.longitude_deg - w.meridian_deg, 360)) > 75)
        base::fail(path, fmt::format("the longitude {:g} west and the time zone of {:g} west do not go together",
                                     w.longitude_deg, w.meridian_deg));
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
