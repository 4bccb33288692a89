// SPDX-License-Identifier: BSD-3-Clause
// The options of a tool, each declared once; reading, -help, -defaults, "did you mean" and what a scene's file may say
// follow from the declaration, and a test holds the manual against it.
//     OptionTable t("ptrace", LUXPIPE_VERSION, "[options] scene.rad ...");
//     t.group("Picture");
//     t.add("-x n", "Horizontal resolution", opt.nx).within(1, 32768).from_scene();
//     t.add("-i[+-]", "Irradiance on the surfaces seen instead of radiance", opt.irradiance).from_scene();
//     t.add("-frames N|A:B", "Frames 0 to N-1, or A to B", [&](Arguments& a) { read_frames(a.text(), opt); });
//     if (auto operands = t.parse(argc, argv)) ...   none: a question (-help) was answered
// Spellings are RADIANCE's: one dash, a fixed number of arguments whatever they look like (-vd 0 0 -1), the later of
// two options holds, -i changes a switch and -i+ -i- set it.  Two dashes (--frames 3) and -frames=3 are read, too.
#pragma once
#include <deque>
#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "base/option_target.h"
#include "base/run.h"
#include "base/words.h"

namespace base {

// One declaration.  What add() returns; further facts are added to it.
struct Option {
    std::string group;
    std::string name;       // "-vp"
    std::string arguments;  // "x y z", as -help shows them
    size_t count = 0;       // of these
    std::string sentence;   // without its full stop
    std::string unit_text;
    std::string default_text;  // taken from the variable when it is declared
    Target target;
    Range range;
    bool percent = false;
    bool is_switch = false;
    enum class Joint { apart, joined, either } joint = Joint::apart;
    enum class Scene { refused, allowed, passed_over } scene = Scene::refused;
    std::optional<size_t> unneeded;         // read past, with up to so many whole numbers more
    std::function<std::string()> question;  // its answer goes to stdout and ends the program

    Option& unit(std::string text) { return unit_text = std::move(text), *this; }
    Option& otherwise(std::string text) { return default_text = std::move(text), *this; }
    Option& within(double low, double high) { return range = {low, high, false}, *this; }
    Option& at_least(double low) { return range.low = low, *this; }
    Option& above(double low) { return range.low = low, range.open = true, *this; }
    Option& share() { return percent = true, *this; }  // "50%" is .5
    Option& joined() { return joint = Joint::joined, *this; }
    Option& also_joined() { return joint = Joint::either, *this; }

    // What the file of a scene may say (read_scene_words); without one of these two it may not.
    Option& from_scene() { return scene = Scene::allowed, *this; }
    Option& passed_over_in_scene() { return scene = Scene::passed_over, *this; }

    std::string spelling() const;  // "-vp x y z", "-vtT", "-i[+-]"
    std::string text() const;      // "View point (0 0 0)."
};

class OptionTable {
public:
    OptionTable() = default;  // no tool's: for words in files
    OptionTable(std::string tool, std::string version, std::string usage);
    OptionTable(const OptionTable&) = delete;

    void group(std::string title) { group_ = std::move(title); }

    // A variable (option_target.h lists the types), or a function of the arguments.
    template <class T>
    Option& add(const std::string& spelling, const std::string& sentence, T&& target) {
        return declare(spelling, sentence, into(std::forward<T>(target)));
    }

    // Prints what answer() says and ends the program.
    void question(const std::string& name, const std::string& sentence, std::function<std::string()> answer);

    // An option of another program that is named to refuse it, with the reason.  Without a sentence -help is silent.
    void refuse(const std::string& spelling, const std::string& sentence, const std::string& reason);

    // Options of another program, a blank between two, that are read past with their arguments: so many words, then
    // up to `numbers` whole numbers.
    enum class Scenes { no, yes };
    void unneeded(const std::string& names, size_t arguments, Scenes scenes, size_t numbers = 0);
    std::vector<std::string> unneeded_ones_said() const;  // those with arguments

    void options_come_before(std::string operands) { first_ = std::move(operands); }
    void footer(std::string text) { footer_ = std::move(text); }

    // The whole command line; returns the operands.  Nothing: a question was answered, main ends with status 0.
    std::optional<std::vector<std::string>> parse(int argc, char** argv);

    // After parse(): the program and its words as one line, @files and $VARIABLES replaced by what they said.
    std::string command() const { return command_line(command_); }

    // Words that are options and nothing else: the user's, or those of a scene's file, which may say less.
    void read_words(const std::vector<std::string>& words);
    void read_scene_words(const std::vector<std::string>& words, const std::string& file);

    // The option at the cursor, if it is one of ours.
    bool read(Words& words);

    // What the user has said so far, in order.
    struct Said {
        const Option* option;
        std::vector<std::string> words;
    };
    const std::vector<Said>& said() const { return said_; }
    bool given(const std::string& name) const;

    std::string version() const { return tool_ + " (luxpipe) " + version_ + "\n"; }
    std::string help() const;
    std::string defaults() const;  // the values in force as options, which serve as an @file without the comments

private:
    struct Found {
        const Option* option = nullptr;
        std::optional<std::string> argument;  // what is joined to the name
    };

    Option& declare(const std::string& spelling, const std::string& sentence, Target target);
    Found find(const std::string& word) const;
    void take_arguments(const Found& found, Words& words);
    void ask(const Option& option);
    [[noreturn]] void unknown(const std::string& word) const;
    void require_allowed(const Found& found, const Words& words) const;

    std::string tool_, version_, usage_, group_, first_, footer_;
    std::deque<Option> options_;  // add() gives out references
    std::vector<Said> said_;
    std::vector<std::string> command_;
    bool answered_ = false;
};

}  // namespace base
