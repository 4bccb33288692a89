// SPDX-License-Identifier: BSD-3-Clause
// What options print of themselves: -help and -defaults (options.h).
#include <fmt/core.h>

#include "base/options.h"

namespace base {
namespace {

constexpr size_t text_column = 22, last_column = 100;

// The spelling, then its text in a column of its own, lines broken at blanks.
std::string item(const std::string& spelling, const std::string& text) {
    std::string out = "  " + spelling;
    size_t column = out.size();
    const auto new_line = [&] {
        out += "\n" + std::string(text_column, ' ');
        column = text_column;
    };
    if (column + 2 > text_column) new_line();
    else out.append(text_column - column, ' '), column = text_column;

    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find(' ', at), text.size());
        if (column > text_column && column + 1 + (end - at) > last_column) new_line();
        if (column > text_column) out += ' ', ++column;
        out.append(text, at, end - at);
        column += end - at;
        at = end + 1;
    }
    return out + "\n";
}

// The option with its value, as one would type it; empty where there is nothing to say.
std::string in_force(const Option& o) {
    if (o.is_switch) return o.name + (*o.target.toggle ? "+" : "-");
    if (o.target.toggle) return *o.target.toggle ? o.name : "";
    const std::string value = o.target.show ? o.target.show() : "";
    if (value.empty()) return "";
    return o.name + (o.joint == Option::Joint::joined ? "" : " ") + value;
}

}  // namespace

std::string Option::spelling() const {
    if (is_switch) return name + "[+-]";
    return name + (arguments.empty() || joint == Joint::joined ? "" : " ") + arguments;
}

std::string Option::text() const {
    return sentence + (unit_text.empty() ? "" : " in " + unit_text) +
           (default_text.empty() ? "" : " (" + default_text + ")") + ".";
}

std::string OptionTable::help() const {
    std::string text = "usage: " + tool_ + " " + usage_ + "\n", last, unneeded;
    // The general ones are declared first and read last.
    for (const bool general : {false, true}) {
        for (const Option& o : options_) {
            if ((o.group == "General") != general) continue;
            if (o.unneeded) {
                unneeded += (unneeded.empty() ? "" : " ") + o.name;
                continue;
            }
            if (o.sentence.empty()) continue;
            if (o.group != last) text += o.group + "\n";
            last = o.group;
            text += item(o.spelling(), o.text());
        }
    }
    if (!unneeded.empty()) text += "Accepted and not needed:\n" + item("", unneeded);
    return text + footer_ + "Described in " + tool_ + "(1).\n";
}

std::string OptionTable::defaults() const {
    std::string text;
    for (const Option& o : options_) {
        const std::string words = in_force(o);
        if (!words.empty()) text += fmt::format("{:<31} # {}\n", words, o.text());
    }
    return text;
}

}  // namespace base
