// SPDX-License-Identifier: BSD-3-Clause
// See options.h.  How words are read; what -help and -defaults print is in option_text.cpp.
#include "base/options.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "base/error.h"
#include "base/near.h"
#include "base/split.h"
#include "base/printable.h"
#include "base/run.h"

namespace base {
namespace {

bool turns_on(char c) { return c && std::strchr("+1yYtT", c); }
bool turns_off(char c) { return c && std::strchr("-0nNfF", c); }

bool is_whole_number(const std::string& word) { return word.find_first_not_of("0123456789") == std::string::npos; }

[[noreturn]] void fail_missing(const Option& option) {
    fail(option.name, "an argument is missing (" + option.spelling() + ")");
}

bool names_a_file(const Option& option) {
    const std::string& what = option.arguments;
    return what == "file" || what == "picture" || what == "pattern" || what == "target";
}

// "--frames" is "-frames".
std::string one_dash(const std::string& word) {
    return word.size() > 3 && begins_with(word, "--") ? word.substr(1) : word;
}

std::string lower(std::string text) {
    for (char& c : text) c = char(std::tolower((unsigned char)c));
    return text;
}

std::vector<std::string> split(const std::string& text) {
    std::vector<std::string> words;
    for (size_t at = 0; (at = text.find_first_not_of(' ', at)) != std::string::npos;) {
        const size_t end = std::min(text.find(' ', at), text.size());
        words.push_back(text.substr(at, end - at));
        at = end;
    }
    return words;
}

}  // namespace

OptionTable::OptionTable(std::string tool, std::string version, std::string usage)
    : tool_(std::move(tool)), version_(std::move(version)), usage_(std::move(usage)) {
    group("General");
    question("-defaults", "Print the values in force", [this] { return defaults(); });
    question("-version", "Print the version", [this] { return this->version(); });
    question("-help", "Print the options", [this] { return help(); });
}

Option& OptionTable::declare(const std::string& spelling, const std::string& sentence, Target target) {
    const size_t name_end = std::min(spelling.find_first_of(" ["), spelling.size());
    Option& option = options_.emplace_back();
    option.group = group_;
    option.name = spelling.substr(0, name_end);
    option.is_switch = spelling.substr(name_end) == "[+-]";
    if (!option.is_switch && name_end < spelling.size()) option.arguments = spelling.substr(name_end + 1);
    option.count = split(option.arguments).size();
    option.sentence = sentence;
    if (option.is_switch) option.default_text = *target.toggle ? "on" : "off";
    else if (target.show) option.default_text = target.show();
    option.target = std::move(target);
    return option;
}

void OptionTable::question(const std::string& name, const std::string& sentence, std::function<std::string()> answer) {
    declare(name, sentence, {}).question = std::move(answer);
}

void OptionTable::refuse(const std::string& spelling, const std::string& sentence, const std::string& reason) {
    const auto read = [reason](Arguments& a) { fail(a.name(), reason); };
    declare(spelling, sentence, into(read)).count = 0;  // refused whatever follows
}

void OptionTable::unneeded(const std::string& names, size_t arguments, Scenes scenes, size_t numbers) {
    for (const std::string& name : split(names)) {
        Option& option = declare(name, "", into([](Arguments&) {}));
        option.count = arguments;
        option.unneeded = numbers;
        if (scenes == Scenes::yes) option.from_scene();
    }
}

OptionTable::Found OptionTable::find(const std::string& as_typed) const {
    const std::string word = one_dash(as_typed);
    const size_t equals = word.find('=');
    Found joined;
    for (const Option& o : options_) {
        if (word == o.name) return {&o, {}};
        if (equals != std::string::npos && word.substr(0, equals) == o.name && o.count == 1)
            return {&o, word.substr(equals + 1)};

        if (word.size() <= o.name.size() || !begins_with(word, o.name)) continue;
        const std::string rest = word.substr(o.name.size());
        const bool fits = o.is_switch ? rest.size() == 1 && (turns_on(rest[0]) || turns_off(rest[0]))
                                      : o.joint != Option::Joint::apart;
        if (fits && (!joined.option || o.name.size() > joined.option->name.size())) joined = {&o, rest};
    }
    return joined;
}

void OptionTable::take_arguments(const Found& found, Words& words) {
    const Option& o = *found.option;
    const bool passed_over = o.scene == Option::Scene::passed_over && !words.scene_file().empty();
    if (o.is_switch) {
        if (!passed_over) *o.target.toggle = found.argument ? turns_on((*found.argument)[0]) : !*o.target.toggle;
        return;
    }

    std::vector<std::string> arguments;
    if (found.argument) arguments.push_back(*found.argument);
    else if (o.joint == Option::Joint::joined) fail_missing(o);
    while (arguments.size() < o.count) {
        if (!words.left()) fail_missing(o);
        arguments.push_back(words.take());
    }
    for (size_t i = 0; i < o.unneeded.value_or(0) && words.left() && is_whole_number(words.peek()); ++i) words.take();

    if (passed_over) return;
    if (names_a_file(o) && !arguments.empty() && arguments[0].empty()) fail(o.name, "the name is empty");
    Arguments taken(o, std::move(arguments), words.scene_file());
    o.target.read(taken);
}

void OptionTable::ask(const Option& option) {
    const std::string answer = option.question();
    write_stdout(answer.data(), answer.size());
    answered_ = true;
}

bool OptionTable::read(Words& words) {
    const size_t from = words.at();
    const Found found = find(words.peek());
    if (!found.option) return false;
    words.take();

    if (found.option->question) ask(*found.option);
    else take_arguments(found, words);
    if (words.scene_file().empty()) said_.push_back({found.option, words.since(from)});
    return true;
}

std::optional<std::vector<std::string>> OptionTable::parse(int argc, char** argv) {
    Words words({argv + std::min(argc, 1), argv + argc});
    std::vector<std::string> operands;
    bool operands_only = false;  // after "--"

    while (operands_only ? words.left() > 0 : words.more()) {
        if (operands_only || !words.is_option()) {
            operands.push_back(words.take());
            if (operands.back().empty()) fail("\"\"", "is not the name of a file");
        } else if (words.peek() == "--") {
            operands_only = true;
            words.take();
        } else if (!first_.empty() && !operands.empty()) {
            fail(words.peek(), "options must come before " + first_);
        } else if (!read(words)) {
            unknown(words.peek());
        }
        if (answered_) return std::nullopt;
    }
    command_ = words.all();
    command_.insert(command_.begin(), argc > 0 ? argv[0] : tool_);
    return operands;
}

void OptionTable::read_words(const std::vector<std::string>& list) {
    for (Words words(list); words.more();)
        if (!read(words)) unknown(words.peek());
}

void OptionTable::read_scene_words(const std::vector<std::string>& list, const std::string& file) {
    for (Words words(list, file); words.more();) {
        require_allowed(find(words.peek()), words);
        read(words);
    }
}

// The word itself may come from any file that an @file names, so only its first letters are shown.
void OptionTable::require_allowed(const Found& found, const Words& words) const {
    if (found.option && found.option->scene != Option::Scene::refused) return;
    const std::string &word = words.peek(), &file = words.scene_file();
    if (!words.is_option()) fail(file, "holds a word where an option is expected: a scene may give options only");
    fail(file, "\"" + excerpt(word, 8) + "\" is not a rendering or view option: a scene may not set it");
}

// The nearest option, of several that one that begins alike.  Of one letter only -X is near to -x.
void OptionTable::unknown(const std::string& as_typed) const {
    const std::string whole = one_dash(as_typed), word = lower(whole.substr(0, whole.find('=')));
    const int slip = word.size() <= 2 ? 0 : largest_slip(word.size());
    std::string meant;
    std::pair<int, long> best{slip + 1, 0};  // distance, and less the letters that agree
    for (const Option& o : options_) {
        if (o.sentence.empty()) continue;
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

bool OptionTable::given(const std::string& name) const {
    return std::any_of(said_.begin(), said_.end(), [&](const Said& said) { return said.option->name == name; });
}

std::vector<std::string> OptionTable::unneeded_ones_said() const {
    std::vector<std::string> names;
    for (const Said& said : said_) {
        const Option& o = *said.option;
        if (o.unneeded && o.count && std::find(names.begin(), names.end(), o.name) == names.end())
            names.push_back(o.name);
    }
    return names;
}

}  // namespace base
