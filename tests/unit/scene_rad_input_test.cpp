// SPDX-License-Identifier: BSD-3-Clause
// scene::read_rad_input against the commands that rad itself prints (golden/rad_input/commands.tsv): the view, the
// final size and those options that a path tracer has.  Options of rad's cache and thresholds are left out on both
// sides.
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <fstream>
#include <map>
#include <set>
#include <sstream>

#include "base/error.h"
#include "scene/rad_input.h"

namespace {

using Options = std::map<std::string, std::string>;

// Option -> its arguments; a later one overrides.
Options by_name(const std::vector<std::string>& words) {
    const std::set<std::string> not_ours = {"-dp", "-ar", "-ds", "-dt", "-dc", "-aa", "-ad", "-as", "-ps", "-pt"};
    Options all;
    std::string name;
    for (const std::string& word : words) {
        const bool option = word[0] == '-' && word.size() > 1 && isalpha((unsigned char)word[1]);
        if (option) name = word, all[name].clear();
        else {
            std::ostringstream number;
            number << std::stod(word);
            all[name] += number.str() + " ";
        }
    }
    for (const std::string& n : not_ours) all.erase(n);
    all.emplace("-ab", "0 ");  // rpict's default, which rad does not say
    return all;
}

std::vector<std::string> split(std::string line) {
    std::vector<std::string> words(1);
    bool quoted = false;
    for (char c : line) {
        if (c == '"') quoted = !quoted;
        else if (c == ' ' && !quoted) words.emplace_back();
        else words.back() += c;
    }
    return words;
}

struct Row {
    std::string id, arguments, commands;
};
std::vector<Row> rows() {
    std::ifstream in(LUXPIPE_TESTS "/golden/rad_input/commands.tsv");
    std::vector<Row> all;
    for (std::string line; std::getline(in, line);) {
        if (line[0] == '#') continue;
        const size_t a = line.find('\t'), b = line.find('\t', a + 1);
        all.push_back({line.substr(0, a), line.substr(a + 1, b - a - 1), line.substr(b + 1)});
    }
    return all;
}

}  // namespace

TEST_CASE("views and options are those of the commands rad prints") {
    REQUIRE(rows().size() == 6);
    for (const Row& row : rows()) {
        CAPTURE(row.id);
        std::string name;
        std::vector<std::string> more, words = split(row.arguments);
        for (size_t i = 1; i < words.size(); ++i) {
            if (words[i] == "-v") name = words[++i];
            else if (words[i].find('=') != std::string::npos) more.push_back(words[i]);
        }
        const scene::RadInput input = scene::read_rad_input(LUXPIPE_TESTS "/golden/rad_input/test.rif", more);
        CHECK(input.scene_files == std::vector<std::string>{"room_cie.rad"});

        // One command a view: " || " stands between them.
        size_t number = 0;
        for (size_t at = 0; at != std::string::npos; ++number) {
            const size_t next = row.commands.find(" || ", at);
            std::vector<std::string> command =
                split(row.commands.substr(at, next == std::string::npos ? next : next - at));
            command.erase(command.begin());  // "rpict"
            at = next == std::string::npos ? next : next + 4;
            Options theirs = by_name(command);
            const std::vector<std::string> view =
                scene::view_words(input, name.empty() ? std::to_string(number + 1) : name);
            std::vector<std::string> all = view;
            all.insert(all.end(), input.options.begin(), input.options.end());
            Options ours = by_name(all);
            // rad renders larger than the final size (QUALITY times) and reduces with pfilt; we render the final size.
            const int times = std::stoi(theirs["-x"]) / std::stoi(ours["-x"]);
            CHECK(std::stoi(theirs["-x"]) == times * std::stoi(ours["-x"]));
            CHECK(std::stoi(theirs["-y"]) == times * std::stoi(ours["-y"]));
            for (const char* size : {"-x", "-y"}) theirs.erase(size), ours.erase(size);
            CHECK(ours == theirs);
        }
    }
}

// rad -n writes for these: oconv sky.rad "!xform -t 0 0 0 quad.rad" 'two words.rad' a"b
TEST_CASE("a quoted word of a scene is one file or command") {
    const scene::RadInput input =
        scene::read_rad_input(LUXPIPE_TESTS "/golden/rad_input/test.rif",
                              {"scene=sky.rad \"!xform -t 0 0 0 quad.rad\"  'two words.rad' a\"b"});
    const std::vector<std::string> files = {"room_cie.rad", "sky.rad", "!xform -t 0 0 0 quad.rad", "two words.rad",
                                            "a\"b"};
    CHECK(input.scene_files == files);
}

TEST_CASE("a wrong file is told by place and fact") {
    const auto message = [](const std::vector<std::string>& more) -> std::string {
        try {
            scene::view_words(scene::read_rad_input(LUXPIPE_TESTS "/golden/rad_input/test.rif", more), "left");
        } catch (const base::Error& e) {
            return e.text;
        }
        return "";
    };
    CHECK(message({}).find("has no view \"left\"") != std::string::npos);
    CHECK(message({"COLOUR=1"}) == "COLOUR=1: \"COLOUR\" is not a variable of rad");
    CHECK(message({"ZONE=I 0 1 0 1"}) == "ZONE: needs xmin xmax ymin ymax zmin zmax");
    CHECK(message({"scene=\"a b"}).find("test.rif: scene: a quote does not end: \"a b") != std::string::npos);
    CHECK(message({"UP=W"}) == "UP: \"W\" is not an axis");
    CHECK(message({"QUALITY=best"}) == "QUALITY: \"best\" is not LOW, MEDIUM or HIGH");
}
