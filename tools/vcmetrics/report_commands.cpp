// SPDX-License-Identifier: BSD-3-Clause
// See report_commands.h.
#include "report_commands.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "base/text_file.h"
#include "base/run.h"
#include "base/split.h"
#include "report/number_table.h"

namespace {

constexpr size_t longest_text = 1 << 16;  // of a changed file in a report
constexpr const char* end_of_text = "END OF TEXT";

void erase(std::string& text, const std::string& part) {
    if (const size_t at = text.find(part); at != std::string::npos) text.erase(at, part.size());
}

std::string word(const std::string& text) { return base::command_line({text}); }

// "materials.changed.rad" of "materials.rad".
std::string changed_name(const std::string& file) {
    const size_t dot = file.rfind('.'), slash = file.rfind('/');
    const bool has_ending = dot != std::string::npos && (slash == std::string::npos || dot > slash);
    return has_ending ? file.substr(0, dot) + ".changed" + file.substr(dot) : file + ".changed";
}

// The word in all places where it stands by itself; false if it does not.
bool replace_word(std::string& line, const std::string& from, const std::string& to) {
    bool any = false;
    for (size_t at = 0; (at = line.find(" " + from, at)) != std::string::npos; at += to.size() + 1) {
        const size_t end = at + 1 + from.size();
        if (end < line.size() && line[end] != ' ') continue;
        line.replace(at + 1, from.size(), to);
        any = true;
    }
    return any;
}

// In a live page a region may be out of sight or not yet drawn; a command by itself may not name it.
void leave_out_regions(const Options& o, const std::vector<std::string>& regions, std::string& own) {
    const auto is_there = [&](const std::string& name) {
        return std::find(regions.begin(), regions.end(), name) != regions.end();
    };
    std::vector<std::string> without;  // columns
    size_t pairs = 0;
    for (const std::string& pair : o.contrast_pairs) {
        const std::string regions_of = pair.substr(pair.find('=') + 1);  // NAME=low/high
        const size_t slash = regions_of.find('/');
        if (is_there(regions_of.substr(0, slash)) && is_there(regions_of.substr(slash + 1))) ++pairs;
        else erase(own, " " + base::command_line({"-cr", pair}));
    }
    if (pairs == 0) without.emplace_back("CR");
    if (regions.empty())
        without.emplace_back("TAL"), erase(own, " " + base::command_line({"-regions", o.regions_file}));
    const size_t at = own.find(" -metrics ");
    if (at == std::string::npos) return;
    const size_t from = at + 10, end = std::min(own.find(' ', from), own.size());
    std::string kept;
    for (const std::string& name : base::split_list(own.substr(from, end - from), ','))
        if (std::find(without.begin(), without.end(), name) == without.end()) kept += (kept.empty() ? "" : ",") + name;
    own.replace(from, end - from, kept);
}

// Lines that write the text that a file has in the page; the commands name it.
std::vector<std::string> changed_file(const Options& o, const std::string& file, const std::string& text_file,
                                      std::vector<std::string>& commands) {
    const std::string text = base::read_text_file(text_file, size_t(1) << 26, o.scene_options.opener(""));
    if (text.size() > longest_text)
        return {"# " + file + " as it was changed in the page is too long for this report: the page saves it"};
    std::string name = changed_name(file);
    bool is_named = false;
    for (std::string& line : commands) is_named = replace_word(line, word(file), word(name)) || is_named;
    std::vector<std::string> lines;
    if (!is_named) name = file, lines.push_back("# in a copy of the folder: this file is part of another one");
    lines.push_back("cat > " + word(name) + " << '" + end_of_text + "'");
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    lines.emplace_back(end_of_text);
    return lines;
}

// Of the regions of a column: "desk" of desk.TAL, "low" and "high" of low/high.CR.
std::vector<std::string> regions_of(const std::string& column) {
    const size_t dot = column.rfind('.');
    if (dot == std::string::npos || column.substr(dot) == ".px") return {};
    return base::split_list(column.substr(0, dot), '/');
}

}  // namespace

void leave_out_undrawn(const std::vector<std::string>& regions, std::vector<report::Page::Number>& numbers) {
    const auto is_undrawn = [&](const report::Page::Number& n) {
        const std::vector<std::string> names = regions_of(n.name);
        return std::isnan(n.value) && std::any_of(names.begin(), names.end(), [&](const std::string& name) {
                   return std::find(regions.begin(), regions.end(), name) == regions.end();
               });
    };
    numbers.erase(std::remove_if(numbers.begin(), numbers.end(), is_undrawn), numbers.end());
}

std::vector<std::string> commands_of(const Options& o, const image::Picture& picture, const std::string& view,
                                     const std::vector<std::string>& regions) {
    const image::Header& h = picture.header;
    std::vector<std::string> commands;
    for (std::string line : h.lines) {
        if (line.find("CAPDATE=") == 0 || line.find("SOFTWARE=") == 0) continue;
        if (const size_t control = line.find(" -control "); h.edit && control != std::string::npos) {
            line.erase(control, line.find(' ', control + 10) - control);
            erase(line, " -watch");
            const size_t scene = o.scene.empty() ? std::string::npos : line.find(" " + o.scene[0]);
            if (scene != std::string::npos)
                line.insert(scene, fmt::format("{} -x {} -y {} -frames 0:{}", view, picture.width, picture.height,
                                               h.frames.value_or(0)));
        }
        commands.push_back(o.files.empty() ? line + " |" : line);
    }
    std::string own = o.command;
    if (!o.numbers_file.empty()) erase(own, " -plan " + o.plan_map + " " + o.plan_numbers);
    erase(own, " -numbers " + o.numbers_file);
    if (h.edit) erase(own, " " + base::command_line({"-day", o.day}));
    for (const Options::Variant& v : o.variants)
        if (h.edit) erase(own, " " + base::command_line({"-variant", v.name, v.picture, v.lines}));
    for (const auto& [file, text] : o.overlays) erase(own, " -overlay " + file + " " + text);
    if (const size_t at = own.find(o.report_file); at != std::string::npos && !o.numbers_file.empty())
        own.replace(at, o.report_file.size(), report::name_in_folder(o.report_file));
    if (h.edit) leave_out_regions(o, regions, own);
    commands.push_back(own);
    std::vector<std::string> script;
    for (const auto& [file, text] : o.overlays) {
        const std::vector<std::string> lines = changed_file(o, file, text, commands);
        script.insert(script.end(), lines.begin(), lines.end());
    }
    script.insert(script.end(), commands.begin(), commands.end());
    return script;
}

std::vector<std::string> lines_in(const std::string& file) {
    std::vector<std::string> out;
    std::istringstream in(base::read_text_file(file, size_t(1) << 24));
    for (std::string line; std::getline(in, line);) out.push_back(line);
    return out;
}
