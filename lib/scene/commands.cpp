// SPDX-License-Identifier: BSD-3-Clause
// "!commands" of scene text.  A command is a pipe of stages; xform stages act on what comes out of the stage before
// them, generators write text, anything else needs -exec.
#include <algorithm>
#include "base/descriptor.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/find_file.h"
#include "base/printable.h"
#include "base/shell.h"
#include "generators/generators.h"
#include "scene/reader.h"

namespace scene {

namespace {
constexpr size_t text_limit = size_t(1) << 30;         // of one command's output
constexpr size_t definitions_limit = size_t(1) << 26;  // of an xform -f file

bool ends_line(const std::string& path, const base::Opener& by) {
    const int fd = base::open_file(path, by);
    char last = '\n';  // also of an empty file, and of one that cannot be read, which its reader reports
    const uint64_t size = base::status_of(fd).stamp.size;
    if (size > 0 && base::read_at(fd, &last, 1, size - 1) != 1) last = '\n';
    base::close_descriptor(fd);
    return last == '\n';
}
}  // namespace

void SceneReader::command(base::TextReader& in) {
    const Deeper deeper(depth_, limits_.depth, in.place());
    const uint32_t line = in.line();
    in.get();  // the "!"
    const std::string text = in.rest_of_line();
    // The command's output counts as this line.
    const base::TextReader here = base::TextReader::from_text("", in.name(), line);
    const CommandLine parsed = split_command(text, here.place());
    if (parsed.stages.size() == 1 && parsed.stages[0].words.empty()) return;
    if (parsed.stages.size() > 100) base::fail(here.place(), "a pipe of more than 100 commands");
    run(parsed, text, parsed.stages.size(), here);
}

// Reads the output of the first `stage` stages.
void SceneReader::run(const CommandLine& line, const std::string& text, size_t stage, const base::TextReader& from) {
    const Stage& last = line.stages[stage - 1];
    if (last.words.empty()) base::fail(from.place(), "an empty command in a pipe");
    const std::string& name = last.words[0];
    if (!line.needs_shell && name == "xform") {
        XformCommand x = parse_xform_command(last.words, from.place());
        if (x.files.empty() && !last.input.empty()) x.files = {last.input};
        if (x.files.empty() && stage == 1) base::fail(from.place(), "xform: no file to transform");
        each_copy(
            x, from.place(), limits_.copies,
            [&](const std::string& file) { return text_of(file, from, definitions_limit); },
            [&](const Transform& t) {
                work_.spend(work_copy, from.place());
                transforms_.push_back(&t);
                if (x.files.empty()) run(line, text, stage - 1, from);
                for (const std::string& file : x.files) read_included(file, from);
                transforms_.pop_back();
            });
    } else if (!line.needs_shell && name == "cat") {
        if (last.words.size() == 1 && stage == 1 && last.input.empty()) base::fail(from.place(), "cat: no file");
        if (last.words.size() == 1 && stage > 1) run(line, text, stage - 1, from);
        else if (last.words.size() == 1) read_included(last.input, from);
        cat({last.words.begin() + 1, last.words.end()}, from);
    } else if (const auto generate = line.needs_shell || stage > 1 ? nullptr : generators::find(name)) {
        std::string out;
        generate(generators::Call{last.words, last.input, from.place(), options_,
                                  static_cast<long long>(std::min<uint64_t>(limits_.copies, 1000000))},
                 out);
        read_text(out, from);
    } else if (options_.exec) {
        read_text(run_shell(text.substr(0, last.end), from.place()), from);
    } else if (line.needs_shell) {
        base::fail(from.place(),
                   "\"!" + base::excerpt(text) + "\" needs a shell (" + line.needs_shell + "); -exec would allow it");
    } else {
        base::fail(from.place(), "command \"" + base::excerpt(name) + "\" is not built in; -exec would allow it");
    }
}

// As oconv has it, a file whose last line does not end goes on with the first line of the next.
void SceneReader::cat(const std::vector<std::string>& files, const base::TextReader& from) {
    bool lines = true;  // each file ends one
    for (size_t i = 0; i + 1 < files.size(); i++)
        lines = lines && ends_line(base::beside(files[i], from.place()), options_.opener(from.place()));
    if (lines) {
        for (const std::string& file : files) read_included(file, from);
        return;
    }
    std::string all;
    for (const std::string& file : files) all += text_of(file, from, text_limit);
    read_text(all, from);
}

std::string SceneReader::text_of(const std::string& file, const base::TextReader& from, size_t limit) {
    base::TextReader in = base::TextReader::from_file(base::beside(file, from.place()), options_.opener(from.place()));
    std::string all;
    for (int c; (c = in.get()) >= 0 && all.size() < limit;) all += char(c);
    work_.spend(work_file + all.size() / work_bytes, from.place());
    return all;
}

void SceneReader::read_text(const std::string& text, const base::TextReader& from) {
    work_.spend(work_file + text.size() / work_bytes, from.place());
    base::TextReader in = base::TextReader::from_text(text, from.name(), from.line());
    if (in.header_format() == "Radiance_octree") return octree(in);  // of "!oconv ..."
    statements(in);
}

std::string SceneReader::run_shell(const std::string& text, const std::string& place) const {
    base::ShellOutput out = base::run_shell(text, text_limit, place);
    if (out.too_long) base::fail(place, "\"" + base::excerpt(text) + "\" writes more than 1 GB");
    if (out.status != 0)
        base::warn(place, "\"" + base::excerpt(text) + "\" ended with status " + std::to_string(out.status));
    return std::move(out.text);
}

}  // namespace scene
