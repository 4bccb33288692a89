// SPDX-License-Identifier: BSD-3-Clause
// See plan.h.
#include "live/plan.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/value.h"
#include "image/points.h"
#include "live/child.h"
#include "live/commands.h"
#include "live/json.h"
#include "live/messages.h"

namespace live {

namespace {
constexpr int64_t first_frames = 4;                 // of the page's picture
constexpr auto patience = std::chrono::seconds(3);  // for a picture that is asked for; a scene may be broken
constexpr double greatest_limit_lx = 1e6;

std::vector<base::FileStamp> stamps_of(const std::vector<std::string>& points) {
    std::vector<base::FileStamp> out;
    for (const std::string& path : points) {
        out.push_back(base::stamp_of(path));
        try {
            for (const image::PointFile& file : image::point_files({path})) out.push_back(base::stamp_of(file.path));
        } catch (const base::Error&) {  // a folder without points: ptrace says so
        }
    }
    return out;
}
}  // namespace

Plan::Plan(const PlanOptions& options, const Files& files, Live& live)
    : options_(options), files_(files), live_(live), given_(files.size()) {
    if (options_.control.empty()) return;
    lines_.emplace(options_.lines);
    show();
}

void Plan::look(bool asked) {
    if (!lines_) return;
    const auto picture = live_.picture();
    if (asked) asked_ = std::chrono::steady_clock::now(), before_ = picture ? picture->header.edit.value_or(0) : -1;
    for (const std::string& line : lines_->read()) take(line);
    const base::FileStamp now = base::stamp_of(options_.sum);
    if (!(now == stamp_)) stamp_ = now, ++number_;
    if (auto points = stamps_of(options_.points); points != points_) {
        if (!points_.empty()) ++points_changes_, number_ += number_ > 0;
        points_ = std::move(points);
    }
    ended_ = begun_ && write_whole(options_.control, "") == Written::nobody;
    send(live_.ask([](const Design& d) {
        std::vector<std::optional<std::string>> all;
        for (const Design::Text& t : d.texts) all.push_back(t.now);
        return all;
    }));
    show();
}

// While the picture of a change has no lines yet, moves, or is paused.
bool Plan::rests() const {
    const auto picture = live_.picture();
    if (!picture || picture->header.edited == "preview") return true;
    if (live_.ask([](const Design& d) { return d.preview || d.paused; })) return true;
    const image::Header& h = picture->header;
    const bool late = std::chrono::steady_clock::now() - asked_ > patience;
    return (h.edit.value_or(0) == before_ && !late) ||
           h.frames.value_or(0) < std::min(first_frames, h.last_frame.value_or(first_frames));
}

void Plan::send(const std::vector<std::optional<std::string>>& texts) {
    const bool rest = rests(), news = !rest && texts != given_;
    if (ended_ || (rest == resting_ && !news)) return;
    std::string bytes = rest ? "pause\n" : "go\n";
    for (size_t n = 0; news && n < texts.size(); ++n)
        if (texts[n] != given_[n]) bytes += overlaying(files_[n], texts[n]);
    if (news) bytes += "what .5 .5\n";
    if (write_whole(options_.control, bytes) != Written::whole) return;
    resting_ = rest, begun_ = true;
    if (news) given_ = texts, ++unanswered_;
}

// The other programs may have said the same of the same files.
void Plan::take(const std::string& line) {
    if (base::begins_with(line, "ptrace: what ")) {
        unanswered_ -= std::min<size_t>(unanswered_, 1);
        long long edit = 0;
        if (base::parse_integer(base::split_list(line, '\t').at(1), edit)) edit_ = edit;
        return;
    }
    const auto said = [&](const Design& d) {
        return std::find(d.messages.begin(), d.messages.end(), line) != d.messages.end();
    };
    if (!line.empty() && !live_.ask(said)) pass_on(line, live_);
}

void Plan::show() {
    const auto texts = live_.ask([](const Design& d) { return d.texts; });
    bool waits = unanswered_ > 0 || points_drawn_ != points_changes_;
    for (size_t n = 0; n < texts.size(); ++n) waits = waits || texts[n].now != given_[n];
    waits_ = waits;
    const std::string text = "{\"number\":" + std::to_string(number_) + ",\"limit\":" + json::number(limit_lx_) +
                             ",\"edit\":" + std::to_string(edit_) + ",\"waits\":" + (waits ? "true" : "false") +
                             ",\"ended\":" + (ended_ ? "true}" : "false}");
    if (text == shown_) return;
    shown_ = text;
    live_.change([&](Design& d) { d.plan = text; });
}

Answer Plan::limit(const std::string& text) {
    double lx;
    if (!lines_) return plain(404, "there is no plan");
    if (!base::parse_real(text, lx) || !(lx > 0 && lx <= greatest_limit_lx)) return plain(400, "no such limit");
    limit_lx_ = lx;
    if (number_ > 0) ++number_;
    show();
    return {204, "", ""};
}

Plan::Drawing Plan::draw(const std::string& map) {
    const size_t number = number_, points = points_changes_;
    std::vector<std::string> command = options_.measure;
    command.insert(command.end(), {"-metrics", "mean,min,median,U0,share" + json::number(limit_lx_), "-format", "jsonl",
                                   "-over", map, "-W-", options_.sum});
    const Outcome done = run(command, "", -1);
    if (done.status == 0) points_drawn_ = points;  // it knows the points of a sum by their hash
    std::ostringstream svg;
    svg << std::ifstream(map, std::ios::binary).rdbuf();
    const std::string row = done.text.substr(0, done.text.find('\n'));
    const size_t edit = row.find("\"edit\": ");
    const bool is_old = edit == std::string::npos || std::atoll(row.c_str() + edit + 8) < edit_;
    return {number, done.status, row, svg.str(), is_old || waits_};
}

Asked::Found Plan::draw() {
    const std::string limit = json::number(limit_lx_);
    const Drawing d = draw(options_.sum + ".svg");
    return {d.number, d.status,
            "\"limit\":" + limit + ",\"numbers\":" + d.row + ",\"map\":" + base::quoted_json(d.map) + "}"};
}

}  // namespace live
