// SPDX-License-Identifier: BSD-3-Clause
// See options.h.  The one file that includes CLI11, which takes long to compile.
// CLI11 stores names, sentences, groups and defaults, sees that no name is declared twice, and converts flags.  Ours
// are: finding and cutting words, for its reader refuses "-until", takes "-1" for an operand and knows no "-vta"
// (decisions/0017); ranges and messages, for its are several lines that name neither program nor place; and the layout
// of -help, for its formatter can tell no option of another program from ours.
#include "base/options.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/run.h"
#include "base/text_file.h"
#include "base/value.h"

namespace base {
namespace {

double in_range(const Range& range, double value, const std::string& name) {
    const std::string text = number_text(value);
    if (range.open && value <= range.low) fail(name, text + " is not above " + number_text(range.low));
    if (value >= range.low && value <= range.high) return value;
    if (std::isinf(range.high)) fail(name, text + " is below " + number_text(range.low));
    fail(name, fmt::format("{} is outside {} to {}", text, number_text(range.low), number_text(range.high)));
}

// Values as arguments.
template <class T>
std::string shown(const T& whole) {
    return std::to_string(whole);
}
std::string shown(const std::string& text) { return text; }
std::string shown(double number) { return number_text(number); }
std::string shown(const std::optional<double>& number) { return number ? number_text(*number) : ""; }
std::string shown(const Vec3& v) { return shown(v.x) + " " + shown(v.y) + " " + shown(v.z); }
std::string shown(const double (&v)[3]) { return shown(Vec3{v[0], v[1], v[2]}); }
std::string shown(const std::vector<std::string>&) { return ""; }

// Arguments as values.
template <class T>
void take(Arguments& a, T& whole) {
    const long value = a.integer();
    whole = T(value);
    if (long(whole) != value || (value < 0 && !std::is_signed_v<T>))
        fail(a.name(), '"' + std::to_string(value) + "\" is too large");
}
void take(Arguments& a, std::string& text) { text = a.text(); }
void take(Arguments& a, std::vector<std::string>& texts) { texts.push_back(a.text()); }
void take(Arguments& a, double& number) { number = a.real(); }
void take(Arguments& a, std::optional<double>& number) { number = a.real(); }
void take(Arguments& a, Vec3& v) { v = a.vec(); }
void take(Arguments& a, double (&v)[3]) {
    for (double& x : v) x = a.real();
}

// "-vp" from "-vp x y z", "-i" from "-i[+-]"; CLI11's names are "--vp" and "--i".
std::string name_of(const std::string& spelling) { return spelling.substr(0, spelling.find_first_of(" [")); }
std::string long_name(const std::string& spelling) { return "-" + name_of(spelling); }

// The spelling, then its text in a column of its own, lines broken at blanks.
std::string item(const std::string& spelling, const std::string& text) {
    constexpr size_t text_column = 22, last_column = 100;
    std::string out, line = fmt::format("  {:<18}  ", spelling);
    const auto end_line = [&] {
        out += CLI::detail::rtrim(line) + "\n";
        line.assign(text_column, ' ');
    };
    if (line.size() > text_column) end_line();
    for (const std::string& word : CLI::detail::split(text, ' ')) {
        if (line.size() > text_column && line.size() + word.size() > last_column) end_line();
        line += word + " ";
    }
    end_line();
    return out;
}

}  // namespace

const std::string& Arguments::name() const { return option_.name; }

long Arguments::integer(const Range& range) {
    const long value = to_int(text(), name());
    for (const Range& r : {option_.range, range}) in_range(r, double(value), name());
    return value;
}

double Arguments::real(const Range& range) {
    const std::string word = text();
    const double value = option_.is_share ? parse_fraction(word, name()) : to_real(word, name());
    return in_range(range, in_range(option_.range, value, name()), name());
}

Vec3 Arguments::vec() {
    const double x = real(), y = real();
    return {x, y, real()};
}

size_t Arguments::one_of(const std::vector<std::string>& names) {
    const std::string word = text();
    const auto at = std::find(names.begin(), names.end(), word);
    if (at == names.end()) fail(name(), "\"" + word + "\" is not one of " + CLI::detail::join(names, ", "));
    return size_t(at - names.begin());
}

Option& Option::unit(const std::string& text) {
    cli->description(cli->get_description() + " in " + text);
    return *this;
}

Option& Option::default_text(const std::string& text) { return cli->default_str(text), *this; }

Option& Option::joined() {
    joint = Joint::joined;
    spelling.erase(name.size(), 1);
    return *this;
}

std::string Option::group() const { return ignored ? "" : cli->get_group(); }

std::string Option::text() const {
    const std::string value = cli->get_default_str();
    return cli->get_description() + (value.empty() ? "" : " (" + value + ")") + ".";
}

std::string Option::in_force() const {
    const std::string value = show ? show() : "";
    if (value.empty() || (count == 0 && !is_switch)) return value.empty() ? "" : name;
    return name + (is_switch || joint == Joint::joined ? "" : " ") + value;
}

OptionTable::OptionTable() : app_(std::make_unique<CLI::App>()) { app_->set_help_flag(); }
OptionTable::~OptionTable() = default;

OptionTable::OptionTable(Text tool, Text version, Text usage) : OptionTable() {
    tool_ = tool, version_ = version, usage_ = "usage: " + tool + " " + usage + "\n";
    group("General");
    question("-defaults", "Print the values in force", [this] { return defaults(); });
    question("-version", "Print the version", [this] { return this->version(); });
    help_ = &add("-help", "Print the options", [this](Arguments& a) {
        const std::string word = a.text();
        const std::vector<std::string>& programs = help_->may_follow;
        answer(help(std::count(programs.begin(), programs.end(), word) ? word : ""));
    });
    help_->may_follow = {"all"};
}

void OptionTable::group(Text title, Text program) {
    group_ = title, program_ = program;
    if (help_ && !program.empty()) help_->may_follow.push_back(program);
}

Option& OptionTable::declare(Text spelling, CLI::Option* cli, std::function<std::string()> show) {
    Option& o = options_.emplace_back();
    o.cli = cli->group(group_);
    o.name = name_of(spelling);
    o.program = program_;
    o.spelling = spelling;
    o.count = size_t(std::count(spelling.begin(), spelling.end(), ' '));
    o.is_switch = spelling == o.name + "[+-]";
    o.show = std::move(show);
    if (o.show) o.default_text(o.show());
    longest_name_ = std::max(longest_name_, o.name.size());

    const std::string argument = spelling.substr(o.name.size());
    if (argument == " file" || argument == " picture" || argument == " pattern" || argument == " target")
        cli->check([name = o.name](const std::string& text) {
            return text.empty() ? fail(name, "the name is empty"), "" : "";
        });
    return o;
}

template <class T, class>
Option& OptionTable::add(Text spelling, Text sentence, T& v) {
    if constexpr (std::is_same_v<T, bool>) {
        Option& o = declare(spelling, app_->add_flag(long_name(spelling), v, sentence), {});
        o.show = [&v, is_switch = o.is_switch] { return v ? "+" : is_switch ? "-" : ""; };
        return o.is_switch ? o.default_text(v ? "on" : "off") : o;
    } else {
        return add(spelling, sentence, {[&v](Arguments& a) { take(a, v); }, [&v] { return shown(v); }});
    }
}
template Option& OptionTable::add(Text, Text, bool&);
template Option& OptionTable::add(Text, Text, int&);
template Option& OptionTable::add(Text, Text, uint64_t&);
template Option& OptionTable::add(Text, Text, double&);
template Option& OptionTable::add(Text, Text, std::optional<double>&);
template Option& OptionTable::add(Text, Text, Vec3&);
template Option& OptionTable::add(Text, Text, double (&)[3]);
template Option& OptionTable::add(Text, Text, std::string&);
template Option& OptionTable::add(Text, Text, std::vector<std::string>&);

Option& OptionTable::add(Text spelling, Text sentence, const Action& action) {
    const auto read = [this, read = action.read](const CLI::results_t& words) {
        Arguments arguments(*carried_out_, words, by_);
        return read(arguments), true;
    };
    Option& o = declare(spelling, app_->add_option(long_name(spelling), read, sentence), action.show);
    o.cli->type_size(std::max(1, int(o.count)));
    return o;
}

void OptionTable::question(Text name, Text sentence, std::function<std::string()> text) {
    add(name, sentence, [this, text](Arguments&) { answer(text()); });
}

void OptionTable::answer(Text text) {
    write_stdout(text.data(), text.size());
    answered_ = true;
}

void OptionTable::refuse(Text spelling, Text sentence, Text reason) {
    Option& o = add(spelling, sentence, [reason](Arguments& a) { fail(a.name(), reason); });
    o.count = 0;  // refused whatever follows
    o.cli->type_size(1)->group(sentence.empty() ? "" : group_);
}

void OptionTable::ignored(Text names, size_t arguments, Scenes scenes, size_t numbers) {
    for (const std::string& name : CLI::detail::split(names, ' ')) {
        Option& o = add(name, "", [](Arguments&) {});
        o.cli->type_size(std::max(1, int(arguments)));
        o.count = arguments;
        o.ignored = numbers;
        if (scenes == Scenes::yes) o.from_scene();
    }
}

const Option* OptionTable::named(Text name) const {
    const CLI::Option* cli = app_->get_option_no_throw("-" + name);
    const auto at = std::find_if(options_.begin(), options_.end(), [&](const Option& o) { return o.cli == cli; });
    return at == options_.end() ? nullptr : &*at;
}

// An option without arguments gets "true", as CLI11's flags do.
void OptionTable::carry_out(const Option& option, std::vector<std::string> arguments, const Opener& by) {
    if (arguments.empty()) arguments.push_back("true");
    by_ = by, carried_out_ = &option;
    option.cli->clear();
    option.cli->add_result(arguments);
    option.cli->run_callback();
}

std::string OptionTable::help(Text program) const {
    std::vector<const Option*> listed;
    std::vector<std::string> groups;
    const bool begins = program.empty() || program == "all";
    std::string text = begins ? usage_ + examples_ : "", ignored;
    for (const Option& o : options_) {
        if (program != "all" && o.program != program) continue;
        listed.push_back(&o);
        if (o.ignored) ignored += " " + o.name;
        if (!o.group().empty() && std::find(groups.begin(), groups.end(), o.group()) == groups.end())
            groups.push_back(o.group());
    }
    // General is declared first and printed last.
    if (!groups.empty() && groups[0] == "General") std::rotate(groups.begin(), groups.begin() + 1, groups.end());
    for (const std::string& group : groups) {
        text += group + "\n";
        for (const Option* o : listed)
            if (o->group() == group) text += item(o->spelling, o->text());
    }
    if (!ignored.empty()) text += "Accepted and not needed:\n" + item("", ignored.substr(1));
    return text + (begins ? footer_ : "") + "Described in " + tool_ + "(1).\n";
}

std::string OptionTable::defaults() const {
    std::string text;
    for (const Option& o : options_)
        if (const std::string words = o.in_force(); !words.empty())
            text += fmt::format("{:<31} # {}\n", words, o.text());
    return text;
}

}  // namespace base
