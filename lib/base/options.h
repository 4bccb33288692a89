// SPDX-License-Identifier: BSD-3-Clause
// The options of a tool, each declared once.  CLI11 holds the declarations: it finds an option by its name, converts
// flags and calls what reads the other arguments (options.cpp).  RADIANCE's spelling stands in front of it
// (command_line.cpp).  A test compares the manual with the declarations.
//     OptionTable t("ptrace", LUXPIPE_VERSION, "[options] scene.rad ...");
//     t.group("Picture");
//     t.add("-x n", "Horizontal resolution", opt.nx).within(1, 32768).from_scene();
//     t.add("-i[+-]", "Irradiance on the surfaces seen instead of radiance", opt.irradiance).from_scene();
//     t.add("-frames N|A:B", "Frames 0 to N-1, or A to B", [&](Arguments& a) { read_frames(a.text(), opt); });
//     if (auto operands = t.parse(argc, argv)) ...   none: a question (-help) was answered
#pragma once
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "base/open_file.h"
#include "base/vec.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace base {

struct ArgCursor;
struct Option;

constexpr double unlimited = std::numeric_limits<double>::infinity();
struct Range {
    double low = -unlimited, high = unlimited;
    bool open = false;  // low itself is too low
};
inline Range within(double low, double high) { return {low, high}; }
inline Range above(double low) { return {low, unlimited, true}; }

// The arguments of one option, for a function that takes them one after another.  Throws Error (place: the option).
class Arguments {
public:
    Arguments(const Option& option, std::vector<std::string> words, Opener by)
        : option_(option), words_(std::move(words)), by_(std::move(by)) {}

    const std::string& name() const;              // the option's, for messages
    const Opener& opener() const { return by_; }  // of files that it names; place: the file that gives it, or empty
    std::string text() { return words_[at_++]; }
    bool next_is(const std::string& word) { return words_[at_] == word && ++at_; }  // then it is passed
    long integer(const Range& range = {});  // within this range and the option's
    double real(const Range& range = {});
    Vec3 vec();
    size_t one_of(const std::vector<std::string>& names);  // their index

private:
    const Option& option_;
    std::vector<std::string> words_;
    Opener by_;
    size_t at_ = 0;
};

// The effect of an option that does more than set a variable.
struct Action {
    std::function<void(Arguments&)> read;
    std::function<std::string()> show;  // the value in force as arguments; none: nothing to show

    Action(std::function<void(Arguments&)> read_, std::function<std::string()> show_) : read(read_), show(show_) {}
    template <class F, class = std::enable_if_t<std::is_invocable_v<F, Arguments&>>>
    Action(F f) : read(f) {}
};

// -x: sets the variable to this.
template <class T>
Action set(T& variable, T value) {
    return [&variable, value](Arguments&) { variable = value; };
}

// -format name: one of these words.
template <class T>
Action one_of(T& variable, std::vector<std::pair<std::string, T>> choices) {
    std::vector<std::string> names;
    for (const auto& choice : choices) names.push_back(choice.first);
    const auto show = [&variable, choices] {
        for (const auto& [name, value] : choices)
            if (value == variable) return name;
        return std::string();
    };
    return {[&variable, choices, names](Arguments& a) { variable = choices[a.one_of(names)].second; }, show};
}

// One declaration.  add() returns it; further facts are appended.
struct Option {
    CLI::Option* cli = nullptr;
    std::string name, spelling;              // "-vp", "-vp x y z"
    size_t count = 0;                        // of arguments
    bool is_switch = false;                  // -i[+-]
    std::function<std::string()> show = {};  // the value in force as arguments
    enum class Joint { apart, joined, either } joint = Joint::apart;
    enum class Scene { refused, allowed, passed_over } scene = Scene::refused;
    bool pixels = false;
    Range range = {};
    bool is_share = false;
    std::optional<size_t> ignored = {};        // read past, with up to so many whole numbers more
    std::string program = {};                  // whose option it is, if another's: only -help PROGRAM lists it
    std::vector<std::string> may_follow = {};  // words of which one may stand behind it: -help PROGRAM

    Option& unit(const std::string& text);
    Option& default_text(const std::string& text);  // a default that the variable does not show
    Option& within(double low, double high, bool open = false) { return range = {low, high, open}, *this; }
    Option& at_least(double low) { return within(low, unlimited); }
    Option& above(double low) { return within(low, unlimited, true); }
    Option& share() { return is_share = true, *this; }  // "50%" is .5
    Option& joined();                                   // -vtT
    Option& also_joined() { return joint = Joint::either, *this; }

    // Allowed in files of a scene (read_scene_words), or ignored there; otherwise an error there.
    Option& from_scene() { return scene = Scene::allowed, *this; }
    Option& passed_over_in_scene() { return scene = Scene::passed_over, *this; }

    // The value decides pixels of frames, and so it enters their fingerprint.
    Option& moves_pixels() { return pixels = true, *this; }

    std::string group() const;     // empty: not in -help
    std::string text() const;      // "View point (0 0 0)."
    std::string in_force() const;  // the option with its value, as one would type it; empty: nothing to say
};

class OptionTable {
public:
    OptionTable();  // no tool's: for words in files
    OptionTable(const std::string& tool, const std::string& version, const std::string& usage);
    ~OptionTable();
    OptionTable(const OptionTable&) = delete;

    // Spelling and arguments as the user types them; a sentence without its full stop; a variable or an action.
    using Text = const std::string&;
    void group(Text title, Text program = "");
    template <class T, class = std::enable_if_t<!std::is_convertible_v<T&, Action>>>
    Option& add(Text spelling, Text sentence, T& variable);  // options.cpp lists the types; of strings one more
    Option& add(Text spelling, Text sentence, const Action& action);

    // Prints this text and ends the program.
    void question(Text name, Text sentence, std::function<std::string()> text);

    // An option of another program that is named to refuse it, with the reason.  Without a sentence -help is silent.
    void refuse(Text spelling, Text sentence, Text reason);

    // Options of another program, a blank between two, that are read past with their arguments: `arguments` words, then
    // up to `numbers` whole numbers.
    enum class Scenes { no, yes };
    void ignored(Text names, size_t arguments, Scenes scenes, size_t numbers = 0);
    std::vector<std::string> ignored_ones() const;  // those that were given and have arguments

    void options_come_before(Text operands) { operands_ = operands; }
    void footer(Text text) { footer_ = text; }
    void examples(Text commands) {
        examples_ = commands;
    }  // with the folder in which they work; -help begins with them

    // The whole command line; returns the operands.  Nothing: a question was answered, main ends with status 0.
    std::optional<std::vector<std::string>> parse(int argc, char** argv);

    // After parse(): the program and its words as one line, @files and $VARIABLES replaced by what they hold.
    std::string command() const { return command_; }

    // Reads words that must all be options: the user's, or a scene file's, which may use fewer options.
    void read_words(const std::vector<std::string>& words);
    void read_scene_words(const std::vector<std::string>& words, Text file);

    // Options among other words, which are skipped, as is an option that cannot be read; `wrong`: what is wrong with
    // the first of these.  True if an option was read.
    bool read_header_words(const std::vector<std::string>& words, std::string& wrong);

    // An option that the user has given, in order.
    struct ParsedOption {
        const Option* option;
        std::vector<std::string> words;
    };
    const std::vector<ParsedOption>& parsed() const { return parsed_; }
    bool given(Text name) const;
    // The @files, and what options themselves have read.
    const FilesRead& files_read() const { return files_read_; }

    const std::deque<Option>& options() const { return options_; }
    std::string version() const { return tool_ + " (luxpipe) " + version_ + "\n"; }
    std::string help(Text program = "") const;  // the tool's own options, PROGRAM's, or all
    std::string defaults() const;  // the values in force as options, which serve as an @file without the comments

private:
    struct Found {
        const Option* option = nullptr;
        std::optional<std::string> joined;  // to the name
    };

    Option& declare(Text spelling, CLI::Option* cli, std::function<std::string()> show);
    const Option* named(Text name) const;
    Found find(Text word) const;
    bool read(ArgCursor& words);
    void answer(Text text);
    void carry_out(const Option& option, std::vector<std::string> arguments, const Opener& by);
    [[noreturn]] void unknown(Text word) const;

    std::string tool_, version_, usage_, examples_, footer_, group_, program_, operands_, command_;
    FilesRead files_read_;
    Opener by_;
    Option* help_ = nullptr;
    const Option* carried_out_ = nullptr;
    std::unique_ptr<CLI::App> app_;
    std::deque<Option> options_;  // add() gives out references
    size_t longest_name_ = 0;
    std::vector<ParsedOption> parsed_;
    bool answered_ = false;
};

}  // namespace base
