// SPDX-License-Identifier: BSD-3-Clause
// DGPf in small pictures, by a pipe of the same programs: of the model of the page, until its own picture has an
// interval, and of the hours of the sky's date, one after another, while that picture is good enough.  The hours begin
// anew when the model, the view or the date is another one.
#include <algorithm>
#include <cmath>
#include <regex>

#include "glare/formulas.h"
#include "live/json.h"
#include "live/steps.h"

namespace live {

namespace {

constexpr int64_t last_frame = 8;    // of a small picture
constexpr int64_t good_enough = 32;  // frames of the page's picture
constexpr int noon = 12;             // the first hour
constexpr double dark_lx = 1;

// Night, beside the hour nearer to noon: no light, or none that this hour has not (lamps).
bool is_dark(double lx, double before, double brightest) {
    return lx < dark_lx || (lx < .2 * brightest && std::abs(lx - before) < .01 * before);
}

// Where the hour of the first sky stands: begin and end; nothing: there is no sky whose hour alone changes it.
std::optional<std::pair<size_t, size_t>> place_of_hour(const std::string& text) {
    static const std::regex sky(R"(\b(gensky|gendaylit)[ \t]+\d+[ \t]+\d+[ \t]+\+?([0-9.:]+))");
    for (size_t at = 0; at < text.size(); at = text.find('\n', at) + 1) {
        const std::string line = text.substr(at, text.find('\n', at) - at);
        std::smatch found;
        if (line[0] == '!' && std::regex_search(line, found, sky)) {
            static const std::regex measured(R"(\s-[WGLE]\s)");
            if (std::regex_search(line, measured)) return {};
            return {{at + size_t(found.position(2)), at + size_t(found.position(2) + found.length(2))}};
        }
        if (text.find('\n', at) == std::string::npos) break;
    }
    return {};
}

Text with_hour(const Text& text, int hour) {
    const auto [from, to] = *place_of_hour(*text);
    return (*text).substr(0, from) + std::to_string(hour) + (*text).substr(to);
}

void end_at(Day& day, int hour) {
    if (hour <= noon) day.ends[0] = true;
    if (hour >= noon) day.ends[1] = true;
}

std::optional<int> next_hour(const Day& day) {
    if (day.hours.empty()) return noon;
    const int first = day.hours.begin()->first, last = day.hours.rbegin()->first;
    const bool before = !day.ends[0] && first > 0, after = !day.ends[1] && last < 24;
    if (before && (!after || noon - first <= last - noon)) return first - 1;
    return after ? std::optional<int>(last + 1) : std::nullopt;
}

// The model of the page at noon: anew where it is another one.
void begin(State& s) {
    Look look = look_now(s);
    std::optional<size_t> sky;
    for (size_t n = 0; n < look.texts.size() && !sky; ++n)
        if (look.texts[n] && place_of_hour(*look.texts[n])) sky = n;
    if (sky) look.texts[*sky] = with_hour(look.texts[*sky], noon);
    if (look == s.day.look) return;
    s.day = {};
    s.day.sky = sky, s.day.look = look;
}

void take_hour(Day& day, const std::array<double, 4>& row) {
    double brightest = 0;
    for (const auto& [hour, of_hour] : day.hours) brightest = std::max(brightest, of_hour[3]);
    const auto nearer = day.hours.find(*day.asked + (*day.asked > noon ? -1 : 1));
    if (is_dark(row[3], nearer == day.hours.end() ? 0 : nearer->second[3], brightest)) end_at(day, *day.asked);
    day.hours[*day.asked] = row;
    day.asked.reset();
}

// The newest row is of this look.
bool has_row(const State& s, const Look& look) {
    const Pipe& p = s.pipe(Which::day);
    return p.sent.empty() && p.edit >= p.first_edit && p.look == look && s.small.edit == p.edit;
}

// The picture of the page has an interval of its own, or somebody moves it.
bool first_can_wait(const State& s) {
    const Pipe& p = s.pipe(Which::picture);
    return s.preview || s.going >= 0 || !s.newest || s.first.failed ||
           (p.look == s.first.look && s.numbers.first == p.edit && !s.numbers.second.empty());
}

// False: it is asked for, and goes before the hours.
bool has_first(State& s, Effects& out) {
    Pipe& p = s.pipe(Which::day);
    First& first = s.first;
    if (const Look now = look_now(s); first.look != now) first = {now};
    if (first.asked && has_row(s, first.look)) first.frame = s.small.frame, first.row = s.small.row;
    if (first.asked) return first.failed || first.frame >= last_frame;
    if (p.stage == Pipe::Stage::ended || first_can_wait(s)) return true;
    if (p.stage == Pipe::Stage::asleep) start(s, out, Which::day);
    first.asked = true;
    s.day.asked.reset();
    tell(s, out, Which::day, first.look, "now");
    return false;
}

}  // namespace

void look_at_day(State& s, Effects& out) {
    Pipe& p = s.pipe(Which::day);
    Day& day = s.day;
    if (p.stage == Pipe::Stage::none) return;
    begin(s);
    if (!has_first(s, out)) return;
    if (day.asked && has_row(s, day.asked_look) && s.small.frame >= last_frame) take_hour(day, s.small.row);
    const image::Picture* shown = s.picture.get();
    if (s.preview || day.asked || !day.sky || !next_hour(day) || p.stage == Pipe::Stage::ended) return;
    if (!shown || shown->header.edited == "preview" || shown->header.frames.value_or(0) < good_enough) return;
    if (p.stage == Pipe::Stage::asleep) start(s, out, Which::day);
    day.asked = next_hour(day);
    day.asked_look = day.look;
    day.asked_look.texts[*day.sky] = with_hour(day.look.texts[*day.sky], *day.asked);
    tell(s, out, Which::day, day.asked_look, std::to_string(*day.asked) + ":00");
}

void take_of_day(State& s, const Measured& m) {
    double low = m.row.of("DGPf.lo"), high = m.row.of("DGPf.hi");
    // The sun in the eye: DGPf is 1 in all of so few frames, and has no interval.  But the illuminance alone bounds it.
    const double dgp = m.row.of("DGPf"), least = glare::least_dgp(m.row.of("Ev.lo"));
    if (dgp == 1 && std::isnan(low) && least > 0) low = least, high = 1;
    s.small = {m.row.edit(), m.row.frame(), {dgp, low, high, m.row.of("Ev")}};
}

// There is no sky at this hour.
void fail_hour(State& s) {
    if (s.first.asked && !s.day.asked) s.first.failed = true;
    if (s.day.asked) end_at(s.day, *s.day.asked);
    s.day.asked.reset();
}

std::string json_of_first(const State& s) {
    const First& f = s.first;
    if (f.look != look_now(s) || f.frame < 0) return "null";
    return json::object({{"frame", std::to_string(f.frame)},
                         {"DGPf", json::number(f.row[0])},
                         {"DGPf.lo", json::number(f.row[1])},
                         {"DGPf.hi", json::number(f.row[2])},
                         {"Ev", json::number(f.row[3])}});
}

// Without the night: no light, or as much as at another hour of that end, which is that of lamps.
std::map<int, std::array<double, 4>> lit_hours(const Day& day) {
    std::map<int, std::array<double, 4>> out = day.hours;
    double brightest = 0;
    for (const auto& [hour, row] : day.hours) brightest = std::max(brightest, row[3]);
    for (const auto& of : day.hours) {
        const bool after = of.first > noon;
        const bool is_night = std::any_of(day.hours.begin(), day.hours.end(), [&](const auto& other) {
            return other.first != of.first && (other.first > noon) == after &&
                   is_dark(of.second[3], other.second[3], brightest);
        });
        if (of.second[3] < dark_lx || (day.ends[after] && is_night)) out.erase(of.first);
    }
    return out;
}

std::string json_of_day(const State& s) {
    if (!s.day.sky) return "null";
    std::vector<std::vector<double>> hours;
    for (const auto& [hour, row] : lit_hours(s.day)) hours.push_back({double(hour), row[0], row[1], row[2]});
    return json::object({{"file", std::to_string(*s.day.sky)},
                         {"hours", json::list_of(hours, json::numbers)},
                         {"ended", json::truth(!next_hour(s.day))}});
}

}  // namespace live
