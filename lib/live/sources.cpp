// SPDX-License-Identifier: BSD-3-Clause
// See sources.h.
#include "live/sources.h"

#include <stdlib.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "base/error.h"
#include "base/split.h"
#include "image/stream.h"
#include "live/child.h"
#include "live/plan.h"

namespace live {

namespace {

constexpr auto longest_wait = std::chrono::milliseconds(3000), step = std::chrono::milliseconds(50);  // of a report

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
    const std::string frame = std::to_string(header.frames.value_or(0)), edit = std::to_string(header.edit.value_or(0));
    std::string names, found;
    size_t frame_at = 0, edit_at = 0;
    for (const std::string& line : lines) {
        const std::vector<std::string> cells = base::split_list(line, '\t');
        const auto at = [&](const char* name) {
            return size_t(std::find(cells.begin(), cells.end(), name) - cells.begin());
        };
        if (at("frame") < cells.size()) names = line, frame_at = at("frame"), edit_at = at("edit");
        else if (frame_at < cells.size() && cells[frame_at] == frame &&
                 (edit_at >= cells.size() || cells[edit_at] == edit))
            found = names + "\n" + line + "\n";
    }
    return found;
}

class TempFolder {
public:
    TempFolder() {
        std::string name = std::filesystem::temp_directory_path() / "vcview.XXXXXX";
        errno = 0;
        if (!mkdtemp(name.data())) base::fail_system(name, "cannot be made");
        path_ = name;
    }
    ~TempFolder() {
        std::error_code gone;
        std::filesystem::remove_all(path_, gone);
    }
    TempFolder(const TempFolder&) = delete;
    std::string write(const std::string& name, const std::string& text) const {
        const std::string path = path_ / name;
        image::write_bytes(path, text);
        return path;
    }
    std::filesystem::path path_;
};

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
    return run_on(*news, command, -1);
}

// -plan, with the maps of the points as the model is now; nothing: there are none.
static std::vector<std::string> plan_of_report(Live& live, Plan& plan, const TempFolder& folder) {
    if (!plan.is_there()) return {};
    const std::string map = folder.path_ / "plan.svg";
    for (auto waited = step; waited < longest_wait; waited += step) {
        const Plan::Drawing d = plan.draw(map);
        if (d.status == 0 && !d.is_old) return {"-plan", map, folder.write("plan", d.row + "\n")};
        std::this_thread::sleep_for(step);
    }
    live.change([](Design& d) { d.tell("vcview: warning: report: has no plan, which is not of the last change yet"); });
    return {};
}

Asked::Found find_report(Live& live, const Files& files, std::vector<std::string> command, Plan& plan) {
    std::optional<Live::News> news;
    std::string table;
    for (auto waited = step; waited < longest_wait && table.empty(); waited += step) {
        news = live.since({}, true);
        if (!news || !news->shown) return {};
        if (news->shown->header.edited != "preview") table = table_of(news->lines, news->shown->header);
        if (table.empty()) std::this_thread::sleep_for(step);
    }
    try {
        const TempFolder folder;
        const std::string page = folder.write("report.html", "");
        command.insert(command.end(), {"-report", page});
        if (!table.empty()) command.insert(command.end(), {"-numbers", folder.write("numbers", table)});
        const std::vector<std::string> maps = plan_of_report(live, plan, folder);
        command.insert(command.end(), maps.begin(), maps.end());
        const auto texts = live.ask([](const Design& d) { return d.texts; });
        for (size_t n = 0; n < texts.size() && n < files.size(); ++n)
            if (texts[n].now && files[n].kind == TextFile::Kind::scene)
                command.insert(command.end(),
                               {"-overlay", files[n].path, folder.write("text" + std::to_string(n), *texts[n].now)});
        Asked::Found found = run_on(*news, command, 2);
        std::ostringstream text;
        text << std::ifstream(page, std::ios::binary).rdbuf();
        found.text = text.str();
        if (found.status == 0 && found.text.empty()) found.status = int(base::Kind::system);
        return found;
    } catch (const base::Error&) {
        return {news->picture, int(base::Kind::system), ""};
    }
}

}  // namespace live
