// SPDX-License-Identifier: BSD-3-Clause
// vcview's options, each declared once (base/options.h), and what they may not say together.
#include "options.h"

#include <algorithm>
#include <cstring>
#include <filesystem>

#include "base/error.h"
#include "base/options.h"
#include "base/split.h"
#include "live/sources.h"

namespace {

// Shows the regions of -regions, which may be written, or else those that the program measures.
void add_regions(const std::string& named, Options& o) {
    using live::TextFile;
    if (!named.empty()) o.files.emplace_back(named, TextFile::Kind::regions, true);
    const auto at = std::find(o.command.begin(), o.command.end(), "-regions");
    if (!named.empty() || at == o.command.end() || at + 1 == o.command.end()) return;
    if (!base::ends_with(at[1], ".exr")) o.files.emplace_back(at[1], TextFile::Kind::regions, false);
}

// The scene where it is a folder, or the folder of its first file: of those that are edited, as others may be of a
// library.
std::string name_of(const std::vector<std::string>& scene, const std::vector<std::string>& edited) {
    if (scene.empty()) return "";
    std::error_code wrong;
    const std::filesystem::path first = std::filesystem::weakly_canonical(scene[0], wrong);
    if (std::filesystem::is_directory(first, wrong)) return first.filename().string();
    if (edited.empty()) return first.parent_path().filename().string();
    return std::filesystem::weakly_canonical(edited[0], wrong).parent_path().filename().string();
}

}  // namespace

std::optional<Options> parse_options(int argc, char** argv) {
    Options o;
    char** const end = argv + argc;
    const auto is_dashes = [](const char* word) { return std::strcmp(word, "--") == 0; };
    char** const dashes = std::find_if(argv, end, is_dashes);
    char** const more = std::find_if(std::min(dashes + 1, end), end, is_dashes);
    if (dashes != end) o.command.assign(dashes + 1, more);
    if (more != end) o.scene.assign(more + 1, end);
    o.server.own = more != end;

    base::OptionTable t("vcview", LUXPIPE_VERSION, "[options] [-- program [argument ...] [-- scene ...]]");
    t.group("Page");
    t.add("-port N", "Port of the page; 0: any that is free", o.server.port).within(0, 65535);
    t.add("-listen address", "Address that serves the page", o.server.listen);
    t.add("-open", "Open the page in the browser (xdg-open)", o.open);
    t.add("-stay", "Show the last picture until interrupted, also after the pipe has ended", o.stay);
    t.add("-messages fifo", "FIFO to which the programs of the pipe write their errors, which the page shows",
          o.messages);
    t.group("Scene");
    t.add("-control file", "FIFO to which the page's commands go (ptrace -control)", o.server.control);
    t.add("-regions file", "Region file that the page shows and writes", o.regions);
    std::vector<std::string> edited;
    t.add("-edit file", "Scene file whose numbers the page changes, and saves on demand; may be repeated",
          [&](base::Arguments& a) { edited.push_back(a.text()); });
    t.add("-view file", "View file that the page offers by its name; may be repeated",
          [&](base::Arguments& a) { o.server.views.push_back(a.text()); });
    t.add("-design file", "Text file that holds what the page has changed, and from which it is opened again",
          o.server.design);
    t.add("-against file", "File of vcmetrics -against, which the page writes: it chooses the variant to compare with",
          o.against);
    std::vector<std::string>& points = o.server.plan.points;
    t.add("-points file", "Points whose illuminance is shown as a plan, of a scene behind a second --; may be repeated",
          [&](base::Arguments& a) { points.push_back(a.text()); });
    std::vector<std::string> scene;
    t.add("-scene file", "Scene of the report, as in vcmetrics; may be repeated",
          [&](base::Arguments& a) { scene.push_back(a.text()); });
    const auto operands = t.parse(int(dashes - argv), argv);
    if (!operands) return std::nullopt;
    if (!operands->empty())
        base::fail(operands->front(), "is no option; the program that reads the pictures comes after --");
    if (dashes != end && o.command.empty()) base::fail("--", "names no program");
    if (o.server.own && o.scene.empty()) base::fail("--", "the second one names no scene");
    if (!points.empty() && !o.server.own) base::fail("-points", "needs a scene behind a second --");
    if (o.server.own && !o.server.control.empty()) base::fail("-control", "is not for a scene behind a second --");
    add_regions(o.regions, o);
    for (const std::string& file : edited) o.files.emplace_back(file, live::TextFile::Kind::scene, true);
    o.server.sources = live::sources_command(o.command);
    o.server.plan.measure = live::plan_command(o.command, points);
    o.server.report = live::report_command(o.command, scene);
    o.server.name = name_of(scene, edited);
    return o;
}
