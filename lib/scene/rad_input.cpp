// SPDX-License-Identifier: BSD-3-Clause
// See rad_input.h.  An assignment a logical line: a backslash continues or quotes, # begins a comment, a variable may
// be cut to its first letters.  The tables are those of rad's manual and of its printed commands (vectors rif_*).
#include "scene/rad_input.h"

#include <fmt/core.h>

#include <cctype>
#include <cmath>
#include <cstring>
#include <map>
#include <sstream>

#include "base/error.h"
#include "base/find_file.h"
#include "base/split.h"
#include "base/value.h"
#include "base/text_file.h"
#include "scene/shell_words.h"

namespace scene {
namespace {

// In the order in which a shortened name is looked for, with the least number of letters.
struct Variable {
    const char* name;
    size_t least;
};
const Variable variables[] = {
    {"AMBFILE", 3},   {"DETAIL", 3},  {"EXPOSURE", 3},  {"EYESEP", 3},      {"illum", 3},      {"INDIRECT", 3},
    {"materials", 3}, {"mkillum", 3}, {"mkpmap", 3},    {"objects", 3},     {"oconv", 3},      {"OCTREE", 3},
    {"OPTFILE", 3},   {"PCMAP", 2},   {"PENUMBRAS", 3}, {"pfilt", 2},       {"PGMAP", 2},      {"PICTURE", 3},
    {"QUALITY", 3},   {"RAWFILE", 3}, {"render", 3},    {"REPORT", 3},      {"RESOLUTION", 3}, {"rpict", 3},
    {"rvu", 3},       {"scene", 3},   {"UP", 2},        {"VARIABILITY", 3}, {"view", 2},       {"ZFILE", 2},
    {"ZONE", 2},
};

struct Values {
    std::map<std::string, std::string> by_name;  // lists joined by a blank
    std::vector<std::string> views;
    std::string get(const char* name) const {
        const auto found = by_name.find(name);
        return found == by_name.end() ? "" : found->second;
    }
};

// File names and "!commands": a word that begins with a quote ends at the next one.
std::vector<std::string> split_quoted(const std::string& text, const std::string& place) {
    std::vector<std::string> words;
    for (size_t at = 0; (at = text.find_first_not_of(" \t", at)) != std::string::npos;) {
        const char quote = text[at] == '"' || text[at] == '\'' ? text[at] : 0;
        const size_t from = quote ? at + 1 : at;
        const size_t to = quote ? text.find(quote, from) : std::min(text.find_first_of(" \t", from), text.size());
        if (to == std::string::npos) base::fail(place, "a quote does not end: " + text.substr(at, 40));
        if (to > from) words.push_back(text.substr(from, to - from));
        at = quote ? to + 1 : to;
    }
    return words;
}

// Blank runs outside quotes become one blank, blanks at the end go.
std::string squeeze(const std::string& text) {
    std::string out;
    char quote = 0;
    for (char c : text) {
        if (quote ? c == quote : c == '"' || c == '\'') quote = quote ? 0 : c;
        if (!quote && std::isspace((unsigned char)c)) {
            if (!out.empty() && out.back() != ' ') out += ' ';
        } else {
            out += c;
        }
    }
    while (!out.empty() && out.back() == ' ') out.pop_back();
    return out;
}

void assign(const std::string& line, const std::string& place, Values& values) {
    size_t at = 0, end;
    while (at < line.size() && std::isspace((unsigned char)line[at])) ++at;
    if (at == line.size()) return;
    for (end = at; end < line.size() && std::isalnum((unsigned char)line[end]);) ++end;
    const std::string name = line.substr(at, end - at);
    while (end < line.size() && (std::isspace((unsigned char)line[end]) || line[end] == '=')) ++end;
    const std::string value = squeeze(line.substr(end));
    for (const Variable& v : variables) {
        if (name.size() < v.least || std::string(v.name).compare(0, name.size(), name) != 0) continue;
        if (std::string(v.name) == "view") {
            values.views.push_back(value);
        } else if (std::islower((unsigned char)v.name[0])) {
            std::string& list = values.by_name[v.name];
            list += (list.empty() ? "" : " ") + value;
        } else {
            values.by_name[v.name] = value;
        }
        return;
    }
    base::fail(place, "\"" + name + "\" is not a variable of rad");
}

Values read_values(const std::string& path, const std::vector<std::string>& more) {
    std::istringstream in(base::read_text_file(path));
    Values values;
    std::string line;
    int number = 1, first = 1;
    bool comment = false;
    for (int c; (c = in.get()) != EOF;) {
        if (c == '\n') {
            assign(line, path + ":" + std::to_string(first), values);
            line.clear();
            comment = false;
            first = ++number;
        } else if (c == '\\') {
            c = in.get();
            if (c == '\r' && in.peek() == '\n') c = in.get();
            if (c == '\n') ++number, line += ' ';
            else if (c != EOF && !comment) line += std::string(in_a_path(char(c)) ? "/" : "") + char(c);
        } else if (!comment && (comment = c == '#') == false) {
            line += char(c);
        }
    }
    assign(line, path + ":" + std::to_string(first), values);
    for (const std::string& text : more) assign(text, text, values);
    return values;
}

// 0, 1, 2 for a beginning of LOW, MEDIUM, HIGH (any case).
int level(const Values& values, const char* name, int fallback) {
    const std::string text = values.get(name);
    if (text.empty()) return fallback;
    const size_t at = std::string("LMH").find(char(std::toupper((unsigned char)text[0])));
    if (at == std::string::npos) base::fail(name, "\"" + text + "\" is not LOW, MEDIUM or HIGH");
    return int(at);
}

bool truth(const Values& values, const char* name) {
    const std::string text = values.get(name);
    if (text.empty()) return false;
    const char c = char(std::toupper((unsigned char)text[0]));
    if (c != 'T' && c != 'F') base::fail(name, "\"" + text + "\" is neither TRUE nor FALSE");
    return c == 'T';
}

void read_zone(const std::string& text, RadInput& input) {
    std::vector<std::string> words = base::split_words(text);
    if (!words.empty() && std::isalpha((unsigned char)words[0][0])) {
        input.interior = std::toupper((unsigned char)words[0][0]) == 'I';
        words.erase(words.begin());
    }
    if (words.size() != 6) base::fail("ZONE", "needs xmin xmax ymin ymax zmin zmax");
    for (int i = 0; i < 6; ++i) input.zone[i] = base::to_real(words[size_t(i)], "ZONE");
    for (int i = 0; i < 3; ++i)
        if (input.zone[2 * i] >= input.zone[2 * i + 1]) base::fail("ZONE", "\"" + text + "\" is empty");
    input.has_zone = true;
}

void read_up(const std::string& text, RadInput& input) {
    const bool sign = !text.empty() && (text[0] == '+' || text[0] == '-');
    const size_t axis = std::string("XYZ").find(char(std::toupper((unsigned char)text.back())));
    if (text.size() != 1u + sign || axis == std::string::npos) base::fail("UP", "\"" + text + "\" is not an axis");
    input.up_axis = int(axis);
    input.up_sign = text[0] == '-' ? -1 : 1;
}

// rad's choice of the options that matter here, render= and rpict= last.
std::vector<std::string> render_options(const Values& values, const RadInput& input) {
    const int quality = level(values, "QUALITY", 0), detail = level(values, "DETAIL", 1);
    std::string text;
    const std::vector<std::string> size =
        base::split_words(values.get("RESOLUTION").empty() ? "512" : values.get("RESOLUTION"));
    text += "-x " + size[0] + " -y " + size[size.size() > 1];
    if (size.size() > 2) text += " -pa " + size[2];
    if (input.has_zone && quality > 0) {
        const double* z = input.zone;
        const double mean = (z[1] - z[0] + z[3] - z[2] + z[5] - z[4]) / 3;
        text += fmt::format(" -ms {:.2g}", mean / ((quality == 1 ? 20 : 40) << detail));
    }
    if (quality > 0 && truth(values, "PENUMBRAS")) text += " -dj .9";
    const char* direct[] = {" -dr 0 -ss 0 -st .5", " -dr 1 -ss 1 -st .1", " -dr 3 -ss 16 -st .01"};
    text += direct[quality];
    const long bounces = values.get("INDIRECT").empty() ? 0 : base::to_int(values.get("INDIRECT"), "INDIRECT");
    text += fmt::format(" -ab {}", quality == 2 ? bounces + 1 : quality == 1 ? bounces : 0);  // 0 is rpict's default
    const double ambient = values.get("EXPOSURE").empty() ? (input.interior ? .01 : 10) : .18 / input.exposure;
    text += fmt::format(" -av {0:.2g} {0:.2g} {0:.2g}", ambient);
    const char* limits[] = {" -lr 6 -lw .001", " -lr 8 -lw 1e-4", " -lr 12 -lw 5e-6"};
    text += limits[quality];
    return base::split_words(text + " " + values.get("render") + " " + values.get("rpict"));
}

// Words of a standard view: signs of x y z in this order, then a type; empty if `name` is none.
std::vector<std::string> standard_view(const RadInput& input, const std::string& name) {
    int sign[3] = {0, 0, 0};
    size_t at = 0;
    for (int i = 0; i < 3; ++i)
        if (at < name.size() && std::tolower((unsigned char)name[at]) == "xyz"[i])
            sign[i] = std::isupper((unsigned char)name[at++]) ? 1 : -1;
    if (at == 0 || name.size() > at + 1) return {};
    const char type = at < name.size() ? name[at] : 'v';
    if (!std::strchr("vlahsc", type)) return {};
    if (!input.has_zone) base::fail(input.path, "the standard view \"" + name + "\" needs ZONE=");
    double vp[3], vd[3], squares = 0;
    int axes = 0;
    for (int i = 0; i < 3; ++i) {
        const double low = input.zone[2 * i], high = input.zone[2 * i + 1];
        vp[i] = (low + high) / 2 + (input.interior ? .45 : 2) * sign[i] * (high - low);
        vd[i] = sign[i] ? -sign[i] * (high - low) : 0;
        squares += (high - low) * (high - low);
        axes += sign[i] != 0;
    }
    int up = input.up_axis, up_sign = input.up_sign < 0 ? -1 : 1;
    if (axes == 1 && sign[up]) up = (up + 2) % 3, up_sign = 1;  // along the view: Z -> Y, Y -> X, X -> Z
    const double h = type == 'v' ? 45 : type == 'l' ? std::sqrt(squares) : 180;
    const double v = type == 'c' ? 90 : h;
    return base::split_words(fmt::format(
        "-vt{} -vp {:.3g} {:.3g} {:.3g} -vd {:.3g} {:.3g} {:.3g} -vu {} {} {} -vh {:.3g} -vv {:.3g}", type, vp[0],
        vp[1], vp[2], vd[0], vd[1], vd[2], up == 0 ? up_sign : 0, up == 1 ? up_sign : 0, up == 2 ? up_sign : 0, h, v));
}

std::string up_option(const RadInput& input) {
    if (!input.up_sign) return "";
    return fmt::format("-vu {} {} {} ", input.up_axis == 0 ? input.up_sign : 0, input.up_axis == 1 ? input.up_sign : 0,
                       input.up_axis == 2 ? input.up_sign : 0);
}

// A view= line: a name (also a standard one) and options.
RadInput::NamedView read_view(const RadInput& input, const std::string& line) {
    std::vector<std::string> words = base::split_words(line);
    RadInput::NamedView view;
    if (!words.empty() && words[0][0] != '-') {
        view.name = words[0];
        words.erase(words.begin());
        view.words = standard_view(input, view.name);
    }
    if (view.words.empty()) view.words = base::split_words(up_option(input));
    view.words.insert(view.words.end(), words.begin(), words.end());
    return view;
}

}  // namespace

RadInput read_rad_input(const std::string& path, const std::vector<std::string>& more) {
    const Values values = read_values(path, more);
    RadInput input;
    input.path = path;
    for (const char* name : {"materials", "illum", "scene"})
        for (const std::string& file : split_quoted(values.get(name), path + ": " + name))
            input.scene_files.push_back(file);
    if (input.scene_files.empty()) input.scene_files = split_quoted(values.get("OCTREE"), path + ": OCTREE");
    for (std::string& file : input.scene_files)
        if (file[0] != '!') file = base::beside(file, path + ":1");
    if (input.scene_files.empty()) base::fail(path, "names no scene");
    if (!values.get("ZONE").empty()) read_zone(values.get("ZONE"), input);
    if (!values.get("UP").empty()) read_up(values.get("UP"), input);
    const std::string exposure = values.get("EXPOSURE");
    if (!exposure.empty()) {
        const bool stops = exposure[0] == '+' || exposure[0] == '-';
        const double value = base::to_real(exposure, "EXPOSURE");
        input.exposure = stops ? std::exp2(value) : value;
        if (!(input.exposure > 0)) base::fail("EXPOSURE", "\"" + exposure + "\" is not positive");
    }
    input.options = render_options(values, input);
    for (const std::string& line : values.views) input.views.push_back(read_view(input, line));
    return input;
}

std::vector<std::string> view_words(const RadInput& input, const std::string& name) {
    if (name.empty() && !input.views.empty()) return input.views[0].words;
    for (const RadInput::NamedView& view : input.views)
        if (!name.empty() && view.name == name) return view.words;
    for (size_t i = 0; i < input.views.size(); ++i)
        if (name == std::to_string(i + 1)) return input.views[i].words;
    std::vector<std::string> words = standard_view(input, name.empty() ? "X" : name);
    if (words.empty()) base::fail(input.path, "has no view \"" + name + "\"");
    return words;
}

}  // namespace scene
