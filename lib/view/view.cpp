// SPDX-License-Identifier: BSD-3-Clause
// Views as words: options, VIEW= lines, view files, checks, size to aspect.
// Spelling, defaults and limits are RADIANCE's.
#include "view/view.h"

#include <fmt/format.h>

#include <cctype>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>

#include "base/angle.h"
#include "base/error.h"
#include "base/find_file.h"
#include "base/options.h"
#include "base/split.h"
#include "base/text_file.h"
#include "base/text_reader.h"

namespace view {
namespace {

constexpr double tiny = 1e-6;
using base::degree;
constexpr size_t most_bytes = size_t(64) << 20;  // that are searched for a view: a file may have no end

}  // namespace

bool operator==(const View& a, const View& b) {
    return a.type == b.type && a.vp == b.vp && a.vd == b.vd && a.vu == b.vu && a.vh == b.vh && a.vv == b.vv &&
           a.vo == b.vo && a.va == b.va && a.vs == b.vs && a.vl == b.vl;
}

void declare_options(base::OptionTable& t, View& v, const std::string& default_text) {
    const auto add = [&](const char* spelling, const char* sentence, auto& target) -> base::Option& {
        base::Option& option = t.add(spelling, sentence, target).from_scene();
        if (!default_text.empty()) option.default_text(default_text).show = {};
        return option;
    };
    auto type = base::one_of(v.type, {{"v", 'v'}, {"l", 'l'}, {"a", 'a'}, {"h", 'h'}, {"s", 's'}, {"c", 'c'}});

    t.group("View");
    add("-vp x y z", "View point", v.vp);
    add("-vd x y z", "View direction", v.vd);
    add("-vu x y z", "Upward direction", v.vu);
    add("-vt T",
        "View type: v perspective, l parallel, a angular fisheye, h hemispherical fisheye, s planispheric "
        "(stereographic) fisheye, c cylindrical panorama",
        type)
        .joined();
    add("-vh a", "Horizontal size (for -vtl a length)", v.vh).unit("degrees");
    add("-vv a", "Vertical size (for -vtl a length)", v.vv).unit("degrees");
    add("-vo d", "Fore clipping distance; 0 is none", v.vo);
    add("-va d", "Aft clipping distance; 0 is none", v.va);
    add("-vs f", "Shift to the right, in picture widths", v.vs).share();
    add("-vl f", "Lift, in picture heights", v.vl).share();
}

void declare_file_option(base::OptionTable& t, std::function<void(const View&)> use) {
    const auto read = [=](base::Arguments& a) {
        const std::string name = a.text(), &asker = a.opener().place;
        use(read_view_file(asker.empty() ? name : base::beside(name, asker + ":1"), a.opener()));
    };
    t.add("-vf file", "Take the view from a view file or from the header of a picture", read).from_scene();
}

bool parse_line(View& v, const std::string& line, std::string* wrong) {
    // One table a thread, because declaring takes longer than reading a line.  Without -vf: a header opens no files.
    struct Reader {
        View view;
        base::OptionTable options;
        std::string line, unread;  // of the last call, as are the others
        View before, after;
        bool any = false;
        Reader() { declare_options(options, view); }
    };
    thread_local Reader reader;
    if (line == reader.line && v == reader.before) {  // as in streams
        v = reader.after;
        if (wrong) *wrong = reader.unread;
        return reader.any;
    }

    std::istringstream in(line.compare(0, 5, "VIEW=") == 0 ? line.substr(5) : line);
    reader.view = v;
    std::string unread;
    const bool any = reader.options.read_header_words(
        {std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()}, unread);
    reader.line = line, reader.before = v, reader.after = reader.view, reader.unread = unread, reader.any = any;
    v = reader.view;
    if (wrong) *wrong = unread;
    return any;
}

bool is_view_line(const std::string& line) {
    if (line.compare(0, 5, "VIEW=") == 0) return true;
    std::string_view word(line);
    word = word.substr(0, word.find_first_of(" \t"));
    word.remove_prefix(word.rfind('/') + 1);  // npos + 1 is 0
    for (const char* program : {"rpict", "rvu", "rpiece", "rxpiece", "pinterp", "rview", "evalglare"})
        if (base::begins_with(word, program)) return true;
    return false;
}

void apply_view_file(View& v, const std::string& path, const base::Opener& by) {
    base::TextReader in = base::TextReader::from_file(path, by);
    bool any = false;
    std::string line, wrong;  // wrong: in the last line with a view, which counts
    line.reserve(256);
    size_t bytes = 0;
    for (int c; (c = in.get()) >= 0;) {
        if (++bytes > most_bytes) {
            line.clear();
            break;
        }
        if (c != '\n') {
            if (line.size() >= 1 << 16) base::fail(path, "is not a view file: a line is longer than 65536 characters");
            line += char(c);
            continue;
        }
        if (!line.empty() && line.back() == '\r') line.pop_back();
        if (line.empty() && any) break;  // end of a picture's header
        if (is_view_line(line)) any = parse_line(v, line, &wrong) || any;
        line.clear();
    }
    if (is_view_line(line)) any = parse_line(v, line, &wrong) || any;
    if (!wrong.empty()) base::fail(path, wrong);
    if (!any) base::fail(path, "holds no view (no VIEW= line with a view option)");
}

View read_view_file(const std::string& path, const base::Opener& by) {
    View v;
    apply_view_file(v, path, by);
    return v;
}

namespace {

// View files whose last lines do not end, joined by cat: "... -vv 180rvu -vta ..." is two lines.
std::vector<std::string> lines_of(const std::string& joined) {
    std::vector<std::string> lines;
    size_t from = 0;
    for (size_t at = 1; at < joined.size(); ++at) {
        const bool after_number = std::isdigit((unsigned char)joined[at - 1]) || joined[at - 1] == '.';
        if (!after_number || !is_view_line(joined.substr(at, 64)) || !is_view_line(joined.substr(from, 64))) continue;
        lines.push_back(joined.substr(from, at - from));
        from = at;
    }
    lines.push_back(joined.substr(from));
    return lines;
}

// A line with a view, which starts from the view of the line before.
void take_view(const std::string& line, const std::string& place, View& view, std::vector<NamedView>& all) {
    if (!is_view_line(line) && line.compare(0, 5, "view=") != 0) return;
    std::istringstream words(line.substr(line.find_first_of("= \t") + 1));
    std::string name;
    words >> name;
    if (name.size() > 1 && name[0] == '-' && std::isalpha((unsigned char)name[1])) name.clear();  // an option
    std::string wrong;
    const bool any = parse_line(view, line, &wrong);
    if (!wrong.empty()) base::fail(place, wrong);
    if (!any) return;
    try {
        validate(view);
    } catch (const base::Error& e) {
        base::fail(place + ": " + e.where, e.message);
    }
    all.push_back({name, view});
}

}  // namespace

std::vector<NamedView> read_views(const std::string& path, const View& start) {
    const bool from_stdin = path == "-";
    const std::string where = from_stdin ? "stdin" : path;
    std::ifstream file;
    errno = 0;
    if (!from_stdin) file.open(path, std::ios::binary);
    std::istream& in = from_stdin ? std::cin : file;
    if (!in) base::fail_system(path, "cannot be read");

    std::vector<NamedView> all;
    View view = start;
    size_t bytes = 0, number = 0;
    for (std::string line; std::getline(in, line);) {
        ++number;
        if (number == 1 && base::begins_with(line, base::byte_order_mark)) line.erase(0, base::byte_order_mark.size());
        if ((bytes += line.size() + 1) > most_bytes) base::fail(where, "is not a list of views: it does not end");
        for (const std::string& part : lines_of(line)) take_view(part, fmt::format("{}:{}", where, number), view, all);
    }
    if (in.bad()) base::fail_system(where, "cannot be read");
    if (all.empty()) base::fail(where, "holds no view (no VIEW= line with a view option)");
    return all;
}

std::string to_options(const View& v) {
    // + 0.0 turns -0 into 0
    const auto vec = [](Vec3 a) { return fmt::format("{} {} {}", a.x + 0.0, a.y + 0.0, a.z + 0.0); };
    return fmt::format(" -vt{} -vp {} -vd {} -vu {} -vh {} -vv {} -vo {} -va {} -vs {} -vl {}", v.type, vec(v.vp),
                       vec(v.vd), vec(v.vu), v.vh, v.vv, v.vo, v.va, v.vs + 0.0, v.vl + 0.0);
}

void validate(const View& v) {
    if (base::length(v.vd) == 0) base::fail("-vd", "the view direction has no length");
    if (base::length(v.vu) == 0) base::fail("-vu", "the up vector has no length");
    if (base::length(base::cross(base::unit(v.vd), base::unit(v.vu))) <= tiny)
        base::fail("-vu", "the up vector is parallel to the view direction");
    const auto angle = [](const char* option, double value, double most, bool most_allowed) {
        if (!(value > tiny)) base::fail(option, fmt::format("{} is not above {}", value, value > 0 ? tiny : 0));
        if (most_allowed ? value > most + tiny : value >= most)
            base::fail(option, fmt::format("{} is too wide for this view type ({} {} degrees)", value,
                                           most_allowed ? "at most" : "less than", most));
    };
    switch (v.type) {
    case 'v': angle("-vh", v.vh, 180, false), angle("-vv", v.vv, 180, false); break;
    case 'l': angle("-vh", v.vh, HUGE_VAL, true), angle("-vv", v.vv, HUGE_VAL, true); break;
    case 'a': angle("-vh", v.vh, 360, true), angle("-vv", v.vv, 360, true); break;
    case 'h': angle("-vh", v.vh, 180, true), angle("-vv", v.vv, 180, true); break;
    case 's': angle("-vh", v.vh, 360, false), angle("-vv", v.vv, 360, false); break;
    case 'c': angle("-vh", v.vh, 360, true), angle("-vv", v.vv, 180, false); break;
    default: base::fail("-vt", "the view type is one of v l a h s c");
    }
    if (v.vo < 0) base::fail("-vo", "the fore clipping distance is negative");
    if (v.va < 0) base::fail("-va", "the aft clipping distance is negative");
    if (v.va > 0 && v.va <= v.vo) base::fail("-va", "the aft clipping plane is not behind the fore clipping plane");
}

double aspect(const View& v) {
    switch (v.type) {
    case 'v': return std::tan(v.vv / 2 * degree) / std::tan(v.vh / 2 * degree);
    case 'h': return std::sin(v.vv / 2 * degree) / std::sin(v.vh / 2 * degree);
    case 's': return std::tan(v.vv / 4 * degree) / std::tan(v.vh / 4 * degree);
    case 'c': return 2 * std::tan(v.vv / 2 * degree) / (v.vh * degree);
    default: return v.vv / v.vh;  // l, a
    }
}

void fit_size(const View& v, double pixel_aspect, int& nx, int& ny) {
    if (pixel_aspect <= 0) return;
    const double a = aspect(v);
    if (a * nx > pixel_aspect * ny) nx = int(ny / a * pixel_aspect + .5);
    else ny = int(nx * a / pixel_aspect + .5);
    nx = nx < 1 ? 1 : nx;
    ny = ny < 1 ? 1 : ny;
}

}  // namespace view
