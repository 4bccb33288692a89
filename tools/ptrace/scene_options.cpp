// SPDX-License-Identifier: BSD-3-Clause
// See scene_options.h.
#include "scene_options.h"

#include <algorithm>
#include <cctype>
#include <cstring>

#include "base/error.h"
#include "base/printable.h"

namespace {

const char* const with_arguments[] = {
    "-vf", "-vp", "-vd", "-vu", "-vh", "-vv", "-vo", "-va", "-vs", "-vl",           // the view
    "-x",  "-y",  "-pa", "-pj", "-pd", "-pm", "-ps", "-pt", "-cs", "-cw", "-pRGB",  // the picture
    "-ab", "-av", "-aw", "-aa", "-ar", "-ad", "-as", "-af", "-ai", "-aI", "-ae",   "-aE",
    "-am", "-ap", "-dj", "-ds", "-dt", "-dc", "-dr", "-dp", "-st", "-ss", "-lr",   "-lw",  // light and its ways
    "-me", "-ma", "-mg", "-ms", "-f",                                                      // mist, functions
};
const char* const switches[] = {"-i", "-u", "-bv", "-dv"};  // "-i", "-i+", "-i-" ...

bool is_switch(const std::string& word, const char* name) {
    const size_t n = std::strlen(name);
    if (word.compare(0, n, name) != 0) return false;
    return word.size() == n || (word.size() == n + 1 && std::strchr("+-01yYnNtTfF", word[n]));
}

bool is_scene_option(const std::string& word) {
    const auto same = [&](const char* name) { return word == name; };
    const auto turns = [&](const char* name) { return is_switch(word, name); };
    return (word.size() == 4 && word.compare(0, 3, "-vt") == 0) ||
           std::any_of(std::begin(with_arguments), std::end(with_arguments), same) ||
           std::any_of(std::begin(switches), std::end(switches), turns);
}

}  // namespace

void require_scene_option(const std::string& word, const std::string& file) {
    if (is_scene_option(word)) return;
    if (word.empty() || word[0] != '-')
        base::fail(file, "holds a word where an option is expected: a scene may give no other");
    base::fail(file, "\"" + base::excerpt(word, 8) + "\" is no rendering or view option: a scene may not give it");
}

bool skip_callers_option(base::Words& words) {
    bool unused = false;
    if (words.is_switch("-w", unused)) return true;
    if (!words.is("-t")) return false;
    words.next_string("-t");
    return true;
}
