// SPDX-License-Identifier: BSD-3-Clause
// See sources.h.
#include "live/sources.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/printable.h"
#include "base/split.h"
#include "image/stream.h"
#include "live/child.h"
#include "live/json.h"
#include "live/steps.h"
#include "live/temp_folder.h"

namespace live {

namespace {

constexpr auto longest_try = std::chrono::milliseconds(3000),
               between_tries = std::chrono::milliseconds(50);  // of a report

// vcmetrics' words without these options, which have a value each.
std::vector<std::string> without(const std::vector<std::string>& command, const std::vector<std::string>& options) {
    std::vector<std::string> out{"vcmetrics"};
    if (command.empty() || command[0].substr(command[0].rfind('/') + 1) != "vcmetrics") return out;
    out[0] = command[0];
    for (size_t k = 1; k < command.size(); ++k) {
        std::string word = command[k];
        if (base::begins_with(word, "--")) word.erase(0, 1);
        const std::string name = word.substr(0, word.find('='));
        if (name == "-go-on") continue;
        if (std::find(options.begin(), options.end(), name) == options.end()) out.push_back(command[k]);
        else if (name == word) ++k;  // its value is the next word
    }
    return out;
}

// The program on the newest picture.
Asked::Found run_on(const Live::News& news, const std::vector<std::string>& command, int errors) {
    const Outcome done = run(command, image::picture_bytes(*news.shown, image::Format::flt), errors);
    return {news.picture, done.status, done.text};
}

// The line of a picture, below the names of its columns; empty: it has not come.
std::string table_of(const std::vector<std::string>& lines, const image::Header& header) {
    std::string head, found;
    std::vector<std::string> names;
    for (const std::string& line : lines) {
        const std::vector<std::string> before = names;
        const std::optional<Row> row = read_row(names, line);
        if (names != before) head = line;
        if (row && row->frame() == header.frames.value_or(0) && row->edit() == header.edit.value_or(0))
            found = head + "\n" + line + "\n";
    }
    return found;
}

std::string contents_of(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

struct Drawing {
    size_t number;
    int status;            // of vcmetrics
    std::string row, map;  // its line (jsonl) and the map (SVG)
    bool is_old;           // of the model or the points before a change
};

// map: a file of this name.
Drawing draw(Live& live, const PlanOptions& plan, double limit_lx, const std::string& map) {
    const State before = live.state();
    std::vector<std::string> command = plan.measure, names;
    command.insert(command.end(), {"-metrics", "mean,min,median,U0,share" + json::number(limit_lx), "-format", "jsonl",
                                   "-over", map, "-W-", plan.sum});
    const Outcome done = run(command, "", -1);
    if (done.status == 0) live.put(Drawn{before.plan.points});  // it knows the points of a sum by their hash
    const std::string line = done.text.substr(0, done.text.find('\n'));
    const std::optional<Row> row = read_row(names, line);
    const State now = live.state();
    const bool is_old = !row || row->edit() < now.pipe(Which::plan).edit || plan_waits(now);
    return {before.plan.number, done.status, line, contents_of(map), is_old};
}

}  // namespace

std::vector<std::string> sources_command(const std::vector<std::string>& command) {
    std::vector<std::string> out = without(command, {"-until", "-ci", "-control", "-max-frames", "-max-seconds",
                                                     "-format", "-metrics", "-cr", "-c", "-against", "-over"});
    out.insert(out.end(), {"-sources", "-outlines", "-format", "jsonl", "-W-"});
    return out;
}

std::vector<std::string> report_command(const std::vector<std::string>& command,
                                        const std::vector<std::string>& scene) {
    std::vector<std::string> out = without(command, {"-until", "-control", "-max-frames", "-max-seconds", "-format",
                                                     "-c", "-against", "-over", "-report", "-numbers", "-plan"});
    for (const std::string& file : scene) out.insert(out.end(), {"-scene", file});
    out.push_back("-W-");
    return out;
}

std::vector<std::string> plan_command(const std::vector<std::string>& command, const std::vector<std::string>& points) {
    const auto ci = std::find(command.begin(), command.end(), "-ci");
    std::vector<std::string> out{"vcmetrics", "-ci", command.end() - ci > 1 ? ci[1] : "95"};
    for (const std::string& file : points) out.insert(out.end(), {"-points", file});
    return out;
}

Asked::Found find_sources(const Live& live, const std::vector<std::string>& command) {
    const auto news = live.since({}, true);
    if (!news || !news->shown) return {};
    Asked::Found found = run_on(*news, command, -1);
    while (!found.text.empty() && found.text.back() == '\n') found.text.pop_back();
    std::replace(found.text.begin(), found.text.end(), '\n', ',');
    found.text = json::object({{"picture", std::to_string(found.picture)}, {"sources", "[" + found.text + "]"}});
    return found;
}

Asked::Found find_plan(Live& live, const PlanOptions& plan) {
    const double limit_lx = live.state().plan.limit_lx;
    const Drawing d = draw(live, plan, limit_lx, plan.sum + ".svg");
    return {d.number, d.status,
            json::object({{"number", std::to_string(d.number)},
                          {"limit", json::number(limit_lx)},
                          {"numbers", d.row},
                          {"map", base::quoted_json(d.map)}})};
}

// -plan, with the maps of the points as the model is now; nothing: there are none.
static std::vector<std::string> plan_of_report(Live& live, const PlanOptions& plan, const TempFolder& folder) {
    if (plan.sum.empty()) return {};
    const std::string map = folder.name("plan.svg");
    for (auto waited = between_tries; waited < longest_try; waited += between_tries) {
        const Drawing d = draw(live, plan, live.state().plan.limit_lx, map);
        if (d.status == 0 && !d.is_old) return {"-plan", map, folder.write("plan", d.row + "\n")};
        std::this_thread::sleep_for(between_tries);
    }
    live.put_said(Which::picture, "vcview: warning: report: has no plan, which is not of the last change yet");
    return {};
}

// -variant and -day: pictures and numbers of the variants as far as they are known, hours of the day.
static std::vector<std::string> others_of_report(const State& s, const TempFolder& folder) {
    std::vector<std::string> out;
    for (const Variant& v : s.now.variants) {
        const Result* known = result_of(s, v.look);
        if (!known || !known->picture) continue;
        const std::string of = "variant" + std::to_string(out.size());
        std::string lines;
        for (const std::string& line : known->numbers) lines += line + "\n";
        out.insert(out.end(),
                   {"-variant", v.name, folder.write(of, image::picture_bytes(*known->picture, image::Format::flt)),
                    folder.write(of + ".lines", lines)});
    }
    std::string hours;
    for (const auto& [hour, row] : lit_hours(s.day)) {
        char line[100];
        std::snprintf(line, sizeof line, "%d:00: DGPf %.3f (%.3f to %.3f), %.0f lx at the eye\n", hour, row[0], row[1],
                      row[2], row[3]);
        hours += line;
    }
    if (!hours.empty()) out.insert(out.end(), {"-day", folder.write("day", hours)});
    return out;
}

Asked::Found find_report(Live& live, std::vector<std::string> command, const PlanOptions& plan) {
    std::optional<Live::News> news;
    std::string table;
    for (auto waited = between_tries; waited < longest_try && table.empty(); waited += between_tries) {
        news = live.since({}, true);
        if (!news || !news->shown) return {};
        if (news->shown->header.edited != "preview") table = table_of(news->lines, news->shown->header);
        if (table.empty()) std::this_thread::sleep_for(between_tries);
    }
    try {
        const TempFolder folder;
        const std::string page = folder.write("report.html", "");
        command.insert(command.end(), {"-report", page});
        if (!table.empty()) command.insert(command.end(), {"-numbers", folder.write("numbers", table)});
        const std::vector<std::string> maps = plan_of_report(live, plan, folder);
        command.insert(command.end(), maps.begin(), maps.end());
        const State s = live.state();
        const std::vector<std::string> others = others_of_report(s, folder);
        command.insert(command.end(), others.begin(), others.end());
        for (size_t n = 0; n < s.files.size(); ++n)
            if (s.now.texts[n] && s.files[n].kind == TextFile::Kind::scene)
                command.insert(command.end(), {"-overlay", s.files[n].path,
                                               folder.write("text" + std::to_string(n), *s.now.texts[n])});
        Asked::Found found = run_on(*news, command, 2);
        found.text = contents_of(page);
        if (found.status == 0 && found.text.empty()) found.status = int(base::Kind::system);
        return found;
    } catch (const base::Error&) {
        return {news->picture, int(base::Kind::system), ""};
    }
}

}  // namespace live
