// SPDX-License-Identifier: BSD-3-Clause
// RADIANCE's spelling, in front of CLI11 (options.h): words of a command line become an option and its arguments.
//     -vp 0 0 -1          a fixed number of arguments, whatever they look like
//     -vta, -ofile        an argument joined to the name
//     -i, -i+, -i-        a switch: changed, set, cleared
//     @file, $VARIABLE    the words they hold, where an option or an operand could begin; white space separates, and
//                         there are no quotes; these words are read like typed ones
//     --frames 3, -frames=3 are read as well
// Options are carried out one after another: the later of two holds, and -rif reads options of its own.
#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <cstring>
#include <iterator>
#include <sstream>

#include "base/edit_distance.h"
#include "base/error.h"
#include "base/find_file.h"
#include "base/options.h"
#include "base/printable.h"
#include "base/process.h"
#include "base/run.h"
#include "base/split.h"
#include "base/text_file.h"

namespace base {
namespace {

constexpr size_t most_words = 1000000;

bool is_whole_number(const std::string& word) { return word.find_first_not_of("0123456789") == std::string::npos; }

// After the name of a switch; CLI11 reads them.
bool is_sign(const std::string& text) { return text.size() == 1 && std::strchr("+-10yYnNtTfF", text[0]); }

// "--frames" is "-frames".
std::string one_dash(const std::string& word) {
    return word.size() > 3 && begins_with(word, "--") ? word.substr(1) : word;
}

std::string lower(std::string text) {
    for (char& c : text) c = char(std::tolower((unsigned char)c));
    return text;
}

}  // namespace

// A cursor over words.  by: for @files; its place is where the words stand if a scene gives them, not the user: they
// see no environment, and an @file must be an ordinary file.
struct ArgCursor {
    std::vector<std::string> words;
    Opener by;
    size_t at = 0;
    int expansions = 0;

    const std::string& word() const { return words[at]; }
    size_t left() const { return words.size() - at; }  // as they stand: an option's arguments are not replaced
    bool is_option() const { return word().size() > 1 && word()[0] == '-'; }

    // Contents of @file or $VARIABLE.
    std::string held() const {
        const std::string name = word().substr(1);
        if (word()[0] == '@') {
            constexpr size_t limit = size_t(1) << 20;
            return read_text_file(by.place.empty() ? name : beside(name, by.place + ":1"), limit, by);
        }
        if (!by.place.empty()) fail(by.place, "a scene's file may not ask for an environment variable");
        if (const char* value = std::getenv(name.c_str())) return value;
        fail(word(), "environment variable is not set");
    }

    // True if a word is left; replaces @file and $VARIABLE first.
    bool more() {
        while (left() && word().size() > 1 && (word()[0] == '@' || word()[0] == '$')) {
            if (++expansions > 1000) fail(word(), "expands without end");
            std::istringstream in(held());
            const std::vector<std::string> more_words{std::istream_iterator<std::string>(in), {}};
            words.erase(words.begin() + long(at));
            words.insert(words.begin() + long(at), more_words.begin(), more_words.end());
            if (words.size() > most_words) fail("", "more than a million words of options");
        }
        return left() > 0;
    }
};

// The longest name that the word begins with, if what follows may be joined to it.
OptionTable::Found OptionTable::find(Text as_typed) const {
    const std::string word = one_dash(as_typed);
    for (size_t n = std::min(word.size(), longest_name_); n > 1 && word[0] == '-'; --n) {
        const Option* o = named(word.substr(0, n));
        if (!o) continue;
        const std::string rest = word.substr(n);
        if (rest.empty()) return {o, {}};
        if (rest[0] == '=' && o->count == 1) return {o, rest.substr(1)};
        if (o->is_switch ? is_sign(rest) : o->joint != Option::Joint::apart) return {o, rest};
    }
    return {};
}

// Carries out the option at the cursor; false if none of ours is there.
bool OptionTable::read(ArgCursor& words) {
    const size_t from = words.at;
    const auto [found, joined] = find(words.word());
    if (!found) return false;
    ++words.at;

    const Option& o = *found;
    std::vector<std::string> arguments;
    if (joined) arguments.push_back(*joined);
    else if (o.is_switch) arguments.push_back(o.show() == "+" ? "-" : "+");
    const bool lacks = o.joint == Option::Joint::joined && !joined;
    for (; arguments.size() < o.count; arguments.push_back(words.words[words.at++]))
        if (lacks || !words.left()) fail(o.name, "an argument is missing (" + o.spelling + ")");
    for (size_t i = 0; i < o.ignored.value_or(0) && words.left() && is_whole_number(words.word()); ++i) ++words.at;

    const auto end = o.may_follow.end();
    if (words.left() && std::find(o.may_follow.begin(), end, words.word()) != end)
        arguments.push_back(words.words[words.at++]);

    const bool users = words.by.place.empty();
    if (users || o.scene != Option::Scene::passed_over) carry_out(o, arguments, words.by);
    if (users) parsed_.push_back({&o, {words.words.begin() + long(from), words.words.begin() + long(words.at)}});
    return true;
}

std::optional<std::vector<std::string>> OptionTable::parse(int argc, char** argv) {
    std::vector<std::string> operands, typed = typed_words(argc, argv);
    const std::string program = typed.empty() ? tool_ : typed[0];
    typed.erase(typed.begin(), typed.begin() + std::min(argc, 1));
    ArgCursor words{typed, {"", nullptr, &files_read_}};
    bool operands_only = false;  // after "--"

    while (operands_only ? words.left() > 0 : words.more()) {
        if (operands_only || !words.is_option()) {
            operands.push_back(words.words[words.at++]);
            if (operands.back().empty()) fail("\"\"", "is not the name of a file");
        } else if (words.word() == "--") {
            operands_only = true, ++words.at;
        } else if (!operands_.empty() && !operands.empty()) {
            fail(words.word(),
                 "options must come before " + operands_ + ", but \"" + excerpt(operands.front()) + "\" came first");
        } else if (!read(words)) {
            unknown(words.word());
        }
        if (answered_) return std::nullopt;
    }
    words.words.insert(words.words.begin(), program);
    command_ = command_line(words.words);
    return operands;
}

void OptionTable::read_words(const std::vector<std::string>& list) {
    for (ArgCursor words{list, {"", nullptr, &files_read_}}; words.more();)
        if (!read(words)) unknown(words.word());
}

// A word may come from any file that an @file names, so only its first letters are shown.
void OptionTable::read_scene_words(const std::vector<std::string>& list, Text file) {
    for (ArgCursor words{list, {file, nullptr, &files_read_}}; words.more(); read(words)) {
        const Option* option = find(words.word()).option;
        if (option && option->scene != Option::Scene::refused) continue;
        if (!words.is_option()) fail(file, "holds a word where an option is expected: a scene may give options only");
        fail(file, "\"" + excerpt(words.word(), 8) + "\" is not a rendering or view option: a scene may not set it");
    }
}

bool OptionTable::read_header_words(const std::vector<std::string>& list, std::string& wrong) {
    parsed_.clear();
    wrong.clear();
    for (ArgCursor words{list, {}}; words.left();) {
        const size_t next = words.at + 1;
        try {
            if (!read(words)) words.at = next;
        } catch (const Error& e) {
            words.at = next;
            if (wrong.empty()) wrong = e.text;
        }
    }
    return !parsed_.empty();
}

// Names the nearest option, preferring one that begins alike.  Among options of one letter only -X is near to -x.
void OptionTable::unknown(Text as_typed) const {
    if (as_typed == "-h") fail(as_typed, "unknown option; did you mean -help?");
    const std::string whole = one_dash(as_typed), word = lower(whole.substr(0, whole.find('=')));
    const int slip = word.size() <= 2 ? 0 : largest_slip(word.size());
    std::string meant;
    std::pair<int, long> best{slip + 1, 0};  // distance, and less the letters that agree
    for (const Option& o : options_) {
        if (o.group().empty()) continue;
        const std::string name = lower(o.name);
        const int distance = word.size() > 3 && begins_with(name, word) ? 1 : edit_distance(word, name);
        const size_t least = std::min(word.size(), name.size());
        const auto differ = std::mismatch(word.begin(), word.begin() + long(least), name.begin());
        const std::pair<int, long> rank{distance, -(differ.first - word.begin())};
        if (rank >= best || distance > slip) continue;
        best = rank;
        meant = o.name;
    }
    fail(as_typed, "unknown option; " + (meant.empty() ? tool_ + " -help lists them" : "did you mean " + meant + "?"));
}

bool OptionTable::given(Text name) const {
    return std::any_of(parsed_.begin(), parsed_.end(), [&](const ParsedOption& p) { return p.option->name == name; });
}

std::vector<std::string> OptionTable::ignored_ones() const {
    std::vector<std::string> names;
    for (const auto& [option, words] : parsed_)
        if (option->ignored && option->count && std::find(names.begin(), names.end(), option->name) == names.end())
            names.push_back(option->name);
    return names;
}

}  // namespace base
