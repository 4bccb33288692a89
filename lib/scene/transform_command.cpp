// SPDX-License-Identifier: BSD-3-Clause
// xform's command line.  -f is expanded first (outermost), then -a from left to right (the first is the slowest):
// "-a N" becomes "-i k".  Copies are named: the first -n (arrays: every -n) gets ".k", or "-n ak" / "-n ik" is put in
// front.
#include <algorithm>
#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "scene/shell_words.h"
#include "scene/transform.h"

namespace scene {

namespace {

using Words = std::vector<std::string>;

// Number of words after an option; -1 = no option of xform.
int option_arguments(const std::string& w) {
    if (w == "-n" || w == "-m" || w == "-f" || w == "-a") return 1;
    if (w == "-c" || w == "-e" || w == "-I") return 0;
    if (!base::is_xform_option(w)) return -1;
    return w == "-t" ? 3 : w[1] == 'm' ? 0 : 1;
}

size_t find_option(const Words& words, const char* option) {
    for (size_t i = 0; i < words.size(); i++) {
        if (words[i] == option) return i;
        i += std::max(0, option_arguments(words[i]));
    }
    return words.size();
}

void add_number(Words& words, const std::string& letter, const std::string& number, bool all) {
    std::string name;
    std::vector<size_t> places;
    for (size_t i = 0; i < words.size(); i++) {
        if (words[i] == "-n" && i + 1 < words.size() && (all || places.empty())) places.push_back(i + 1);
        i += std::max(0, option_arguments(words[i]));
    }
    if (places.empty()) words.insert(words.begin(), {"-n", letter + number});
    else name = words[places.back()] + "." + number;
    for (size_t i : places) words[i] = name;
}

Transform plain(const Words& words, const std::string& place) {
    Transform t;
    size_t i = 0;
    for (; i < words.size() && !base::is_xform_option(words[i]); i++) {
        const std::string& w = words[i];
        if (w == "-n") t.prefix += (t.prefix.empty() ? "" : ".") + words[i + 1];
        else if (w == "-m" && t.modifier.empty()) t.modifier = words[i + 1];
        else if (w == "-I") t.invert = true;
        i += std::max(0, option_arguments(w));
    }
    t.words.assign(words.begin() + i, words.end());
    const size_t used = parse_xform({words.data(), words.size()}, i, t.matrix, place);
    if (i + used < words.size())
        base::fail(place, "xform: option " + base::excerpt(words[i + used]) + " must come before the transform");
    return t;
}

}  // namespace

XformCommand parse_xform_command(const Words& words, const std::string& place) {
    XformCommand c;
    size_t i = 1;
    for (; i < words.size() && words[i].size() > 1 && words[i][0] == '-'; i++) {
        const int n = option_arguments(words[i]);
        if (n < 0) base::fail(place, "xform: unknown option " + base::excerpt(words[i]));
        if (i + n >= words.size()) base::fail(place, "xform: option " + words[i] + " lacks its argument");
        c.words.insert(c.words.end(), words.begin() + i, words.begin() + i + n + 1);
        i += n;
    }
    c.files.assign(words.begin() + i, words.end());
    return c;
}

void each_copy(const XformCommand& command, const std::string& place, uint64_t limit, const OpenFile& read_text,
               const std::function<void(const Transform&)>& body) {
    uint64_t copies = 0, steps = 0, promised = 1;
    for (size_t i = 0; i + 1 < command.words.size(); i += 1 + std::max(0, option_arguments(command.words[i]))) {
        long long n;
        if (command.words[i] != "-a" || !base::parse_integer(command.words[i + 1], n) || n <= 0) continue;
        promised *= std::min<uint64_t>(uint64_t(n), limit + 1);
        if (promised > limit) base::fail(place, "xform: more than " + std::to_string(limit) + " copies");
    }
    const std::function<void(const Words&, int)> expand = [&](const Words& words, int depth) {
        if (depth > 100) base::fail(place, "xform: more than 100 arrays in one command");
        if (++steps > 2 * limit + 100) base::fail(place, "xform: more than " + std::to_string(limit) + " copies");
        size_t at = find_option(words, "-f");
        if (at < words.size()) {
            const std::string text = read_text(words[at + 1]);
            size_t k = 0, line = 0;
            for (size_t begin = 0; begin < text.size();) {
                const size_t end = std::min(text.find('\n', begin), text.size());
                const std::string where = words[at + 1] + ":" + std::to_string(++line);
                std::string row = text.substr(begin, end - begin);
                begin = end + 1;
                if (!row.empty() && row[0] == '!') row.erase(0, 1);
                Words line_words = split_command(row, where).stages[0].words;
                if (!line_words.empty() && line_words[0] == "xform") line_words.erase(line_words.begin());
                if (line_words.empty()) continue;
                Words copy(words.begin(), words.begin() + at);
                for (size_t i = 0; i < line_words.size(); i++) {
                    const int n = option_arguments(line_words[i]);
                    if (n < 0 || i + n >= line_words.size())
                        base::fail(where, "xform: bad option or missing argument at " + base::excerpt(line_words[i]));
                    i += n;
                }
                copy.insert(copy.end(), line_words.begin(), line_words.end());
                copy.insert(copy.end(), words.begin() + at + 2, words.end());
                add_number(copy, "i", std::to_string(k++), false);
                expand(copy, depth + 1);
            }
            return;
        }
        at = find_option(words, "-a");
        if (at < words.size()) {
            long long n;
            if (!base::parse_integer(words[at + 1], n) || n < 0)
                base::fail(place, "xform: -a needs a number of copies, not \"" + base::excerpt(words[at + 1]) + "\"");
            for (long long k = 0; k < n; k++) {
                Words copy = words;
                copy[at] = "-i";
                copy[at + 1] = std::to_string(k);
                add_number(copy, "a", std::to_string(k), true);
                expand(copy, depth + 1);
            }
            return;
        }
        if (++copies > limit) base::fail(place, "xform: more than " + std::to_string(limit) + " copies");
        body(plain(words, place));
    };
    expand(command.words, 0);
}

}  // namespace scene
