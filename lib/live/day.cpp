// SPDX-License-Identifier: BSD-3-Clause
// See day.h.
#include "live/day.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include "base/split.h"
#include "live/commands.h"
#include "live/json.h"

namespace live {

namespace {

constexpr int side = 64;             // pixels
constexpr int64_t last_frame = 8;    // of an hour
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

std::string with_hour(const std::string& text, int hour) {
    const auto [from, to] = *place_of_hour(text);
    return text.substr(0, from) + std::to_string(hour) + text.substr(to);
}

}  // namespace

Day::Day(std::string control, const std::string& lines, const Files& files, Live& live)
    : control_(std::move(control)), files_(files), live_(live) {
    if (!control_.empty()) lines_.emplace(lines);
}

void Day::look() {
    if (!lines_) return;
    const Live::Numbers now = live_.numbers();
    if (now.design != seen_.design || now.files != seen_.files) begin();
    seen_ = now;
    for (const std::string& line : lines_->read()) take(line);
    const auto picture = live_.picture();
    const bool moves = live_.ask([](const Design& d) { return d.preview.has_value(); });
    if (!moves && sky_ && picture && picture->header.edited != "preview" &&
        picture->header.frames.value_or(0) >= good_enough)
        ask_next();
}

void Day::begin() {
    const auto [stand, view] = live_.ask([](const Design& d) {
        std::vector<std::optional<std::string>> all;
        for (const Design::Text& t : d.texts) all.push_back(t.now);
        return std::pair(all, d.views.empty() ? "" : d.views.back());
    });
    std::vector<std::string> texts;
    for (size_t n = 0; n < files_.size(); ++n)
        texts.push_back(files_[n].kind == TextFile::Kind::regions ? "" : stand[n] ? *stand[n] : files_[n].read().text);
    std::optional<size_t> sky;
    for (size_t n = 0; n < texts.size() && !sky; ++n)
        if (place_of_hour(texts[n])) {
            sky = n;
            texts[n] = with_hour(texts[n], noon);
        }
    if (texts == texts_ && view == view_) return;
    texts_ = std::move(texts), view_ = view, sky_ = sky;
    given_ = ends_[0] = ends_[1] = false;
    hours_.clear(), asked_.reset(), edit_.reset();
    show();
}

void Day::end_at(int hour) {
    if (hour <= noon) ends_[0] = true;
    if (hour >= noon) ends_[1] = true;
}

bool Day::send(const std::string& bytes) { return write_whole(control_, bytes) == Written::whole; }

std::optional<int> Day::next_hour() const {
    if (hours_.empty()) return noon;
    const int first = hours_.begin()->first, last = hours_.rbegin()->first;
    const bool before = !ends_[0] && first > 0, after = !ends_[1] && last < 24;
    if (before && (!after || noon - first <= last - noon)) return first - 1;
    return after ? std::optional<int>(last + 1) : std::nullopt;
}

// Texts, view and size once; then the sky of one hour after another.  "what" tells which edit the hour has become.
void Day::ask_next() {
    if (asked_ || !next_hour()) return;
    if (pipe_ == Pipe::asleep && send("begin\n")) pipe_ = Pipe::called;
    if (pipe_ != Pipe::awake) return;
    std::string bytes;
    if (!given_) {
        bytes = "size " + std::to_string(side) + " " + std::to_string(side) + "\n";
        for (size_t n = 0; n < files_.size(); ++n)
            if (files_[n].kind != TextFile::Kind::regions) bytes += overlaying(files_[n], texts_[n]);
        if (!view_.empty()) bytes += "view" + view_ + "\n";
    }
    const int hour = *next_hour();
    bytes += overlaying(files_[*sky_], with_hour(texts_[*sky_], hour)) + "what .5 .5\n";
    if (!send(bytes)) return;
    given_ = true;
    asked_ = hour;
    edit_.reset();
}

void Day::take(const std::string& line) {
    if (pipe_ == Pipe::called) return void(pipe_ = Pipe::awake);
    const std::vector<std::string> cells = base::split_list(line, '\t');
    if (base::begins_with(line, "ptrace: what ") && cells.size() > 1) edit_ = cells[1];
    else if (base::begins_with(line, "frame\t")) columns_ = cells;
    else if (base::begins_with(line, "ptrace: ") && line.find(": warning: ") == line.npos && asked_) {
        end_at(*asked_);  // there is no sky at this hour
        asked_.reset();
    }
    const auto at = [&](const char* name) {
        const size_t c = size_t(std::find(columns_.begin(), columns_.end(), name) - columns_.begin());
        return c < cells.size() ? cells[c] : "";
    };
    const auto number = [&](const char* name) { return std::strtod(at(name).c_str(), nullptr); };
    if (cells.size() == columns_.size() && cells != columns_ && number("frame") >= double(last_frame))
        rows_[at("edit")] = {number("DGPf"), number("DGPf.lo"), number("DGPf.hi"), number("Ev")};
    if (!asked_ || !edit_ || !rows_.count(*edit_)) return;
    const std::array<double, 4> row = rows_[*edit_];
    rows_ = {{*edit_, row}};
    double brightest = 0;
    for (const auto& [hour, of_hour] : hours_) brightest = std::max(brightest, of_hour[3]);
    const auto nearer = hours_.find(*asked_ + (*asked_ > noon ? -1 : 1));
    if (is_dark(row[3], nearer == hours_.end() ? 0 : nearer->second[3], brightest)) end_at(*asked_);
    hours_[*asked_] = row;
    asked_.reset();
    show();
}

void Day::show() {
    std::string text;
    for (const auto& [hour, row] : hours_)
        if (row[3] >= dark_lx)
            text += (text.empty() ? "" : ",") + json::numbers({double(hour), row[0], row[1], row[2]});
    text = sky_ ? "{\"file\":" + std::to_string(*sky_) + ",\"hours\":[" + text +
                      "],\"ended\":" + (next_hour() ? "false}" : "true}")
                : "null";
    live_.change([&](Design& d) { d.day = text; });
}

}  // namespace live
