// SPDX-License-Identifier: BSD-3-Clause
// ptrace's command line: read, what -rif brings, and what does not go together.
#include "options.h"

#include <sys/stat.h>

#include <algorithm>

#include "base/error.h"
#include "base/find_file.h"
#include "base/processors.h"
#include "base/run.h"
#include "base/warnings.h"
#include "declare.h"
#include "image/stream.h"
#include "scene/rad_input.h"

namespace {

// View options after -rif override the view that is chosen by its name.
std::vector<std::string> view_words_after_rif(const base::OptionTable& table) {
    std::vector<std::string> words;
    bool after = false;
    for (const auto& [option, said] : table.said()) {
        after = after || option->name == "-rif";
        if (after && option->group == "View") words.insert(words.end(), said.begin(), said.end());
    }
    return words;
}

void choose_view(const scene::RadInput& rad_input, const std::string& name, base::OptionTable& table, Options& opt) {
    opt.view = view::View();
    table.read_scene_words(scene::view_words(rad_input, name), rad_input.path);
    table.read_words(view_words_after_rif(table));
}

void check(const Options& opt) {
    if (opt.scene_files.empty()) base::fail("", "no scene file; ptrace -help lists the options");
    view::validate(opt.view);
    if (!opt.rule_for.empty()) return;
    if (!opt.output.empty()) {
        if (opt.last == Options::endless) base::fail("-frames", "say how many frames to write to files");
        if (opt.last > opt.first && output_name(opt.output, 0) == output_name(opt.output, 1))
            base::fail("-o", "\"" + opt.output + "\" needs a %d for the number of the frame");
        image::require_writable_ending(output_name(opt.output, opt.first));
        return;
    }
    struct stat info = {};
    if (fstat(1, &info) != 0) base::fail_system("stdout", "cannot be written");
    if (base::stdout_is_terminal()) base::fail("stdout", "pictures are binary; pipe them or name files with -o");
    const bool reader = S_ISFIFO(info.st_mode) || S_ISSOCK(info.st_mode);
    if (!reader && opt.last == Options::endless)
        base::fail("-frames", "say how many frames; stdout has no reader that could end the stream");
}

// "QUALITY=Low" after a rad input file stands for a line at its end, as on rad's own command line.  What the file says
// is read where -rif stands among the options; so the command line is read again once such words have been seen.
std::optional<int> parse(int argc, char** argv, const std::vector<std::string>& assignments, Options& opt) {
    opt.files.raypath = base::raypath_from_environment();
    opt.files.work = base::work_from_environment();
    std::optional<scene::RadInput> rad_input;
    base::OptionTable table("ptrace", LUXPIPE_VERSION, "[options] scene.rad ... (\"-\": stdin)");
    declare_options(table, opt, rad_input, assignments);
    auto operands = table.parse(argc, argv);
    if (!operands) return 0;

    if (rad_input) {
        const auto split = std::stable_partition(operands->begin(), operands->end(), [](const std::string& word) {
            return word.find('=') == std::string::npos;
        });
        const std::vector<std::string> said(split, operands->end());
        if (assignments != said) {
            opt = Options();
            return parse(argc, argv, said, opt);
        }
        operands->erase(split, operands->end());
        if (operands->size() > 1) base::fail("-rif", "one view name at most, not \"" + (*operands)[1] + "\" too");
        opt.scene_files = rad_input->scene_files;
        choose_view(*rad_input, operands->empty() ? "" : operands->front(), table, opt);
    } else {
        opt.scene_files = *operands;
    }
    base::search_beside(opt.scene_files, opt.files);
    opt.command = table.command();
    base::use_processors(unsigned(opt.threads));
    if (!opt.warnings) base::set_warning_sink({});
    std::string unneeded;
    for (const std::string& name : table.unneeded_ones_said()) unneeded += " " + name;
    if (!unneeded.empty()) base::warn("", "a path tracer does not need" + unneeded);
    check(opt);
    view::fit_size(opt.view, opt.pixel_aspect, opt.nx, opt.ny);
    return std::nullopt;
}

}  // namespace

std::string output_name(const std::string& pattern, int64_t k) {
    const size_t at = pattern.find('%');
    if (at == std::string::npos) return pattern;
    size_t end = at + 1;
    while (end < pattern.size() && pattern[end] >= '0' && pattern[end] <= '9') ++end;
    const std::string width = pattern.substr(at + 1, end - at - 1);
    if (end == pattern.size() || pattern[end] != 'd' || width.size() > 2 || pattern.find('%', end) != std::string::npos)
        base::fail("-o", "\"" + pattern + "\" must hold one %d, such as %04d");
    const std::string number = std::to_string(k);
    const size_t wide = width.empty() ? 0 : std::stoul(width);
    const std::string pad(wide > number.size() ? wide - number.size() : 0, width[0] == '0' ? '0' : ' ');
    return pattern.substr(0, at) + pad + number + pattern.substr(end + 1);
}

std::optional<int> parse_options(int argc, char** argv, Options& opt) { return parse(argc, argv, {}, opt); }
