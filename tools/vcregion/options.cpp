// SPDX-License-Identifier: BSD-3-Clause
// See options.h.  One table holds every option once: its arguments, its line of help and what reads it.
#include "options.h"
#include <functional>
#include <fmt/core.h>
#include "base/error.h"
#include "base/radopts.h"
#include "base/run.h"
#include "base/warnings.h"
#include "image/stream.h"

namespace {
using base::Words;

struct Row {
    const char* name;
    const char* args;
    const char* help;
    std::function<void(Words&)> read;  // none: another reader's (the view's), or a question
};

int size_of(Words& w, const char* name) {
    long n = w.next_int(name);
    if (n < 1 || n > 32768) base::fail(name, fmt::format("{} is outside 1 to 32768", n));
    return int(n);
}

std::vector<Row> table(Options& o) {
    return {
        {"-vf", "file", "view from a view file or a picture",
         [&](Words& w) {
             o.view = view::read_view_file(w.next_string("-vf"));
             o.view_given = true;
         }},
        {"-vt", "T", "view type, joined: v l a h s c", {}},
        {"-vp", "x y z", "view point", {}},
        {"-vd", "x y z", "view direction", {}},
        {"-vu", "x y z", "view up", {}},
        {"-vh", "a", "horizontal size (degrees; -vtl: length)", {}},
        {"-vv", "a", "vertical size", {}},
        {"-vo", "d", "fore clipping distance", {}},
        {"-va", "d", "aft clipping distance", {}},
        {"-vs", "f", "shift", {}},
        {"-vl", "f", "lift", {}},
        {"-x", "n", "horizontal resolution", [&](Words& w) { o.nx = size_of(w, "-x"); }},
        {"-y", "n", "vertical resolution", [&](Words& w) { o.ny = size_of(w, "-y"); }},
        {"-pa", "f", "pixel aspect, 0 keeps -x and -y", [&](Words& w) { o.pixel_aspect = w.next_real("-pa"); }},
        {"-o", "file", "masks (.exr), one mask (.hdr, with -single) or preview (.png, with -over)",
         [&](Words& w) { o.outputs.push_back(w.next_string("-o")); }},
        {"-centre", "", "a pixel is in or out by its centre", [&](Words&) { o.centre = true; }},
        {"-single", "name", "one region as a mask for evalglare -A",
         [&](Words& w) { o.single = w.next_string("-single"); }},
        {"-list", "", "print pixels, solid angle, share and centre of the regions", [&](Words&) { o.list = true; }},
        {"-over", "picture", "preview over this picture; its size, and its view unless one is given",
         [&](Words& w) { o.over = w.next_string("-over"); }},
        {"-exec", "", "let the scene run its !commands", [&](Words&) { o.files.exec = true; }},
        {"-w", "+-", "warnings", {}},
        {"-defaults", "", "print the values in force", {}},
        {"-version", "", "print the version", {}},
        {"-help", "", "print this list", {}},
    };
}

void print(const std::string& text) { base::write_stdout(text.data(), text.size()); }

void print_help(Options& o) {
    std::string text = "usage: vcregion [options] regions.txt [scene.rad ...]\n";
    for (const Row& row : table(o)) {
        const bool joined = row.args[0] == '+' || std::string(row.name) == "-vt";
        text += fmt::format(
            "  {:<18} {}\n",
            row.name + std::string(joined || !*row.args ? "" : " ") + (row.args[0] == '+' ? "[+-]" : row.args),
            row.help);
    }
    print(text + "Described in vcregion(1), the file of regions in vcregion(5).\n");
}

void print_defaults(const Options& o) {
    std::string view_options = view::to_options(o.view), text;
    for (size_t at; (at = view_options.find(" -v")) != std::string::npos;) {
        const size_t next = view_options.find(" -v", at + 1);
        text += view_options.substr(at + 1, next == std::string::npos ? next : next - at - 1) + "\n";
        view_options.erase(0, next);
    }
    print(text + fmt::format("-x {}\n-y {}\n-pa {:g}\n-w{}\n", o.nx, o.ny, o.pixel_aspect, o.warnings ? "+" : "-"));
}

bool answer(Words& w, Options& o) {
    if (w.is("-help") || w.is("--help")) print_help(o);
    else if (w.is("-defaults")) print_defaults(o);
    else if (w.is("-version") || w.is("--version")) print("vcregion (luxpipe) " LUXPIPE_VERSION "\n");
    else return false;
    return true;
}

bool read_option(Words& w, Options& o) {
    if (w.is_switch("-w", o.warnings)) return true;
    for (const Row& row : table(o))
        if (row.read && w.is(row.name)) {
            row.read(w);
            return true;
        }
    if (const int n = view::parse_option(o.view, w.all(), w.at())) {
        w.skip(size_t(n));
        o.view_given = true;
        return true;
    }
    return false;
}

void check(const Options& o) {
    if (o.regions.empty()) base::fail("", "no region file; vcregion -help lists the options");
    for (const std::string& name : o.outputs) {
        const std::string ending = image::ending_of(name);
        if (ending == ".exr") {
        } else if (ending == ".hdr" || ending == ".pic") {
            if (o.single.empty())
                base::fail(name, "a RADIANCE picture holds one mask; name it with -single, or write .exr");
        } else if (ending == ".png") {
            if (o.over.empty()) base::fail(name, "a preview needs -over picture");
        } else {
            base::fail(name, "masks are written to .exr, one mask to .hdr or .pic, a preview to .png");
        }
    }
    if (!o.over.empty()) {
        bool png = false;
        for (const std::string& name : o.outputs) png = png || image::ending_of(name) == ".png";
        if (!png) base::fail("-over", "name the preview: -o file.png");
    }
    if (o.outputs.empty() && !o.list) {
        if (o.single.empty()) base::fail("", "nothing to write: give -o masks.exr, -list or -single name");
        if (base::stdout_is_terminal()) base::fail("stdout", "a mask is binary; pipe it or name a file with -o");
    }
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, Options& o) {
    o.files.raypath = base::raypath_from_environment();
    o.files.work = base::work_from_environment();
    Words words({argv + 1, argv + argc});
    while (words.more()) {
        if (!words.is_option()) {
            if (o.regions.empty()) o.regions = words.take();
            else o.scene.push_back(words.take());
        } else if (!o.regions.empty()) {
            base::fail(words.peek(), "options come before the region file");
        } else if (answer(words, o)) {
            return 0;
        } else if (!read_option(words, o)) {
            base::fail(words.peek(), "no such option; vcregion -help lists them");
        }
    }
    base::search_beside(o.scene, o.files);
    if (!o.warnings) base::set_warning_sink({});
    check(o);
    return std::nullopt;
}
