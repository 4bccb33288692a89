// SPDX-License-Identifier: BSD-3-Clause
// See own.h.
#include "own.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <memory>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "live/outbox.h"
#include "live/programs.h"
#include "live/temp_folder.h"

using live::Which;

Wake::Wake() {
    errno = 0;
    if (!base::make_pipe(ends_)) base::fail_system("pipe", "cannot be made");
}

void Wake::call() const {
    const ssize_t written = write(ends_[1], "", 1);
    (void)written;  // one byte fits
}

void Wake::wait() const { base::wait_for_input(ends_[0]); }

Shown::Shown(const live::Server& server, bool open) {
    base::say("vcview: " + server.link());
    if (open) browser_.emplace(server.link());
}

namespace {

const char* const commands_from = "/dev/stdin";

live::Words joined(live::Words words, const live::Words& more) {
    words.insert(words.end(), more.begin(), more.end());
    return words;
}

// The hours of the day and the points of the plan have less right to the processor.
live::Command command_of(Which which, const Options& o, const live::Words& measure) {
    const live::Words live{"-watch", "-control", commands_from}, nice{"nice", "-n", "5", "ptrace"};
    if (which == Which::picture)
        return {joined(joined({"ptrace"}, live), o.scene), {"ptaccum", "-every", "x2/16"}, measure};
    if (which == Which::day)
        return {joined(joined(joined(nice, {"-w-", "-frames", "9"}), live), o.scene),
                {"ptaccum", "-every", "1"},
                {"vcmetrics", "-metrics", "Ev,DGPf", "-ci", "95"}};
    live::Words points;
    for (const std::string& file : o.server.plan.points) points = joined(points, {"-points", file});
    return {joined(joined(joined(joined(nice, {"-frames", "255"}), live), points), o.scene),
            {"nice", "-n", "5", "ptaccum", "-every", "x2/16", "-batches", "16", "-o", o.server.plan.sum},
            {}};
}

// There while we are, and afterwards if there is something in it.
class RegionFile {
public:
    explicit RegionFile(const std::string& path) : path_(std::filesystem::exists(path) ? "" : path) {
        if (!path_.empty()) std::ofstream{path_};
    }
    ~RegionFile() {
        std::error_code wrong;
        if (!path_.empty() && std::filesystem::file_size(path_, wrong) == 0) std::filesystem::remove(path_, wrong);
    }
    RegionFile(const RegionFile&) = delete;

private:
    const std::string path_;
};

// vcmetrics -against reads a file of ours instead of the word that stands there.
std::string name_against(live::Words& measure, std::string& word, std::optional<live::TempFolder>& folder) {
    const auto at = std::find(measure.begin(), measure.end(), "-against");
    if (measure.end() - at < 2) return "";
    word = at[1];
    if (!folder) folder.emplace();
    return at[1] = folder->write("against", word);
}

}  // namespace

int show_scene(Options options) {
    std::optional<live::TempFolder> folder;
    if (!options.server.plan.points.empty()) options.server.plan.sum = folder.emplace().name("sum.exr");
    std::optional<RegionFile> regions;
    if (!options.regions.empty()) regions.emplace(options.regions);
    live::Words measure = options.command;
    const std::string against = name_against(measure, options.server.against, folder);

    live::Live page(options.files);
    page.set_against(against);
    const Wake wake;
    const auto ended = [&] {
        if (const live::State s = page.state(); s.ended && !s.picture) wake.call();
    };
    std::array<std::unique_ptr<live::Programs>, 3> programs;
    page.begin([&](live::State& s) {
        s.control = commands_from;
        for (const Which which : {Which::picture, Which::day, Which::plan}) {
            if (which == Which::plan && options.server.plan.points.empty()) continue;
            using Stage = live::Pipe::Stage;
            s.pipe(which).own = true;
            s.pipe(which).stage = which == Which::picture ? Stage::ended : Stage::asleep;
            programs[size_t(which)] =
                std::make_unique<live::Programs>(which, command_of(which, options, measure), page, ended);
        }
    });
    page.on_effect([&](const live::Effect& e) {
        if (const auto* s = std::get_if<live::Start>(&e)) programs[size_t(s->which)]->start();
        if (const auto* to = std::get_if<live::ToPipe>(&e)) programs[size_t(to->which)]->send(to->bytes);
    });
    live::Outbox none;
    std::optional<live::Server> server(std::in_place, page, none, options.server);
    const Shown shown(*server, options.open);
    page.ask({"/start", [](const char*) { return std::string(); }});
    wake.wait();
    base::leave_stdout();
    server.reset();
    page.on_effect({});  // what the last rows ask for comes too late
    for (auto& one : programs) one.reset();
    return page.state().ended.value_or(0);
}
