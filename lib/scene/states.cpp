// SPDX-License-Identifier: BSD-3-Clause
// See states.h.
#include "scene/states.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "base/printable.h"
#include "base/run.h"
#include "base/split.h"
#include "scene/shell_words.h"

namespace scene {
namespace {

const char* const place = "-state";

struct Change {
    std::string name;
    std::vector<std::string> without, with;
};

struct Group {
    std::string name;  // empty: the only one
    std::vector<Change> states;
};

// Apart at blanks, as a shell does it.
std::vector<std::string> words_of(const std::string& text) {
    if (text.find_first_not_of(" \t") == std::string::npos) return {};
    const CommandLine line = split_command(text, place);
    if (line.needs_shell != 0 || line.stages.size() > 1)
        base::fail(place, "\"" + base::excerpt(text) + "\" is neither names of files nor a command behind !");
    return line.stages[0].words;
}

std::string checked_name(const std::string& name, const std::string& word) {
    const auto is_odd = [](unsigned char c) {
        return c <= ' ' || c == 0x7f || std::string("/+=,:\"").find(char(c)) != std::string::npos;
    };
    if (name.empty() || name[0] == '.' || name[0] == '-' || std::any_of(name.begin(), name.end(), is_odd))
        base::fail(place, fmt::format("\"{}\": \"{}\" is not a name", base::excerpt(word), base::excerpt(name)));
    return name;
}

Change change_of(const std::string& name, const std::string& what) {
    Change change{name, {}, {}};
    if (!what.empty() && what[0] == '!') {
        change.with = {what};
        return change;
    }
    for (const std::string& word : words_of(what)) {
        const bool is_signed = word[0] == '-' || word[0] == '+';
        const std::string file = word.substr(is_signed);
        if (file.empty()) base::fail(place, "\"" + base::excerpt(what) + "\": a name of a file follows + and -");
        (word[0] == '-' ? change.without : change.with).push_back(file);
    }
    return change;
}

std::vector<Group> groups_of(const std::vector<std::string>& words) {
    std::vector<Group> groups;
    for (const std::string& word : words) {
        const size_t end = std::min(word.find('='), word.size()), slash = word.find('/');
        const std::string group = slash < end ? checked_name(word.substr(0, slash), word) : "";
        const size_t begin = slash < end ? slash + 1 : 0;
        const std::string name = checked_name(word.substr(begin, end - begin), word);
        auto known = std::find_if(groups.begin(), groups.end(), [&](const Group& g) { return g.name == group; });
        if (known == groups.end()) known = groups.insert(groups.end(), {group, {}});
        for (const Change& c : known->states)
            if (c.name == name) base::fail(place, "two states are called \"" + word.substr(0, end) + "\"");
        known->states.push_back(change_of(name, end < word.size() ? word.substr(end + 1) : ""));
    }
    for (const Group& g : groups)
        if (g.name.empty() && groups.size() > 1)
            base::fail(place, "\"" + g.states[0].name + "\" is of no group, but others are");
    return groups;
}

void apply(const Change& change, std::vector<std::string>& files) {
    size_t at = files.size();
    for (const std::string& file : change.without) {
        const auto found = std::find(files.begin(), files.end(), file);
        if (found == files.end())
            base::fail(place, fmt::format("{}: \"{}\" is not a file of the scene", change.name, base::excerpt(file)));
        at = std::min(at, size_t(found - files.begin()));
        files.erase(found);
    }
    files.insert(files.begin() + long(std::min(at, files.size())), change.with.begin(), change.with.end());
}

}  // namespace

std::vector<State> states_of(const std::vector<std::string>& words, const std::vector<std::string>& files) {
    const std::vector<Group> groups = groups_of(words);
    size_t count = 1;
    for (const Group& g : groups)
        if ((count *= g.states.size()) > most_states)
            base::fail(place, fmt::format("the states of all groups make more than {} combinations", most_states));
    std::vector<State> all{{"", files}};
    for (const Group& g : groups) {
        std::vector<State> more;
        for (const State& before : all)
            for (const Change& c : g.states) {
                State& s = more.emplace_back(before);
                if (!s.name.empty()) s.name += "+";
                s.name += g.name + (g.name.empty() ? "" : "/") + c.name;
                apply(c, s.files);
            }
        all = std::move(more);
    }
    return all;
}

std::vector<std::string> honeybee_states(const std::vector<std::string>& files) {
    const std::string ending = "..default..0.rad";
    std::vector<std::string> words;
    for (const std::string& file : files) {
        if (!base::ends_with(file, ending)) continue;
        const std::string stem = file.substr(0, file.size() - ending.size()), group = stem.substr(stem.rfind('/') + 1);
        words.push_back(group + "/0");
        for (size_t k = 1;; ++k) {
            const std::string other = fmt::format("{}..default..{}.rad", stem, k);
            std::error_code absent;
            if (!std::filesystem::exists(other, absent)) break;
            words.push_back(fmt::format("{}/{}={}", group, k, base::command_line({"-" + file, "+" + other})));
        }
    }
    if (words.empty())
        base::fail("-honeybee-states", "the scene has no aperture group and no dynamic shade of Honeybee");
    return words;
}

}  // namespace scene
