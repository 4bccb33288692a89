// SPDX-License-Identifier: BSD-3-Clause
// See shade_rules.h.
#include "year/shade_rules.h"

#include <fmt/format.h>

#include <filesystem>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/text_file.h"
#include "base/split.h"

namespace year {
namespace {

// The words of a rule, taken one after another.
class RuleWords {
public:
    RuleWords(std::vector<std::string> words, std::string place) : words_(std::move(words)), place_(std::move(place)) {}
    bool any() const { return at_ < words_.size(); }
    bool next_is(const std::string& word) { return any() && words_[at_] == word && ++at_; }
    bool next_is_number() const {
        double v;
        return any() && base::parse_real(number_text(), v);
    }
    std::string word(const char* what) {
        if (!any()) base::fail(place_, std::string(what) + " is missing");
        return words_[at_++];
    }
    bool next_is_watts() {  // "150W"
        double v;
        return any() && base::ends_with(words_[at_], "W") && base::parse_real(number_text(), v);
    }
    double number(const char* what, double low, double high) {
        double v = 0;
        if (!any() || !base::parse_real(number_text(), v) || v < low || v > high)
            base::fail(place_, fmt::format("{} is a number from {:g} to {:g}", what, low, high));
        ++at_;
        return v;
    }
    [[noreturn]] void fail(const std::string& fact) const { base::fail(place_, fact); }

private:
    std::vector<std::string> words_;
    std::string place_;
    size_t at_ = 0;
    std::string number_text() const {  // "2%", "150W"
        const std::string& w = words_[at_];
        return base::ends_with(w, "%") || base::ends_with(w, "W") ? w.substr(0, w.size() - 1) : w;
    }
};

// "at desk1,desk2", "until .35", "until morning", in any order.
void read_ends(RuleWords& in, ShadeRule& rule) {
    while (in.any()) {
        if (in.next_is("at")) rule.at = base::split_list(in.word("what is read"), ',');
        else if (rule.wm2 > 0 && in.next_is("weather")) rule.file = in.word("a weather file");
        else if (!in.next_is("until")) in.fail("\"" + base::excerpt(in.word("")) + "\" is not a word of this rule");
        else if (in.next_is("morning")) rule.until_morning = true;
        else if (rule.kind == ShadeRule::Kind::glare) rule.until = in.number("until", 0, rule.limit);
        else in.fail("until: only \"morning\" may follow here");
    }
}

ShadeRule rule_of(const std::string& text, const std::string& place) {
    std::vector<std::string> words = base::split_words(text);
    ShadeRule rule;
    rule.text = text;
    if (base::ends_with(words[0], ":")) {
        rule.group = words[0].substr(0, words[0].size() - 1);
        words.erase(words.begin());
    }
    RuleWords in(words, place);
    const std::string kind = in.word("a rule");
    using Kind = ShadeRule::Kind;
    if (kind == "glare") {
        if (in.next_is_number()) rule.limit = in.number("DGP", 0, 1);
        rule.until = rule.limit;
        read_ends(in, rule);
    } else if (kind == "sun") {
        rule.kind = Kind::sun;
        if (in.next_is_number() && !in.next_is_watts())
            rule.share = in.number("the share of the sensors, in %,", 0, 100) / 100;
        if (in.next_is_watts()) rule.wm2 = in.number("the irradiance", 1e-3, 1500);
        else if (in.next_is_number()) rule.lux = in.number("the illuminance", 1e-3, 2e5);
        read_ends(in, rule);
        if (rule.wm2 > 0 && rule.file.empty()) in.fail("W/m2 need the file that the sun comes from: weather site.epw");
    } else if (kind == "schedule") {
        rule.kind = Kind::schedule;
        rule.file = in.word("a file");
    } else if (kind == "slats") {
        rule.kind = Kind::slats;
        rule.slats.facade_deg = in.number("where the facade looks, in degrees from north over east,", -360, 360);
        rule.slats.width = in.number("the width of a slat", 1e-6, 1e6);
        rule.slats.spacing = in.number("the distance of two slats", 1e-6, 1e6);
        if (!in.next_is("tilts")) in.fail("the tilts of the states are missing: tilts -,0,35");
        rule.tilts = base::split_list(in.word("tilts"), ',');
        for (const std::string& tilt : rule.tilts)
            if (double v; tilt != "-" && (!base::parse_real(tilt, v) || v < -90 || v > 90))
                in.fail("\"" + base::excerpt(tilt) + "\" is no tilt from -90 to 90 degrees, and no -");
        if (!in.next_is("weather")) in.fail("the file that the sun comes from is missing: weather site.epw");
        rule.file = in.word("a weather file");
    } else {
        in.fail("\"" + base::excerpt(kind) + "\" is no rule: glare, sun, schedule and slats are");
    }
    if (in.any()) in.fail("\"" + base::excerpt(in.word("")) + "\" is one word too many");
    return rule;
}

std::string trimmed(const std::string& text) {
    const size_t first = text.find_first_not_of(" \t\r"), last = text.find_last_not_of(" \t\r");
    return first == std::string::npos ? "" : text.substr(first, last - first + 1);
}

}  // namespace

std::vector<ShadeRule> parse_shade_rules(const std::string& text, const std::string& name) {
    std::vector<ShadeRule> rules;
    size_t line = 0;
    std::string rest = text;
    const bool is_file = name != "-shades";
    while (!rest.empty()) {
        const size_t end = std::min(rest.find('\n'), rest.size());
        const std::string whole = rest.substr(0, end);
        rest.erase(0, end + 1);
        ++line;
        for (const std::string& part : base::split_list(whole.substr(0, whole.find('#')), ';'))
            if (const std::string words = trimmed(part); !words.empty())
                rules.push_back(rule_of(words, is_file ? name + ":" + std::to_string(line) : name));
    }
    if (rules.empty()) base::fail(name, "holds no rule");
    return rules;
}

std::vector<ShadeRule> read_shade_rules(const std::string& file_or_words) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(file_or_words, none)) return parse_shade_rules(file_or_words, "-shades");
    constexpr size_t longest = size_t(1) << 20;
    return parse_shade_rules(base::read_text_file(file_or_words, longest), file_or_words);
}

}  // namespace year
