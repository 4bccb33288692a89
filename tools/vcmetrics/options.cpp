// SPDX-License-Identifier: BSD-3-Clause
// See options.h.  One table holds every option once: its arguments, its line of help and what reads it.
#include "options.h"
#include <cstdlib>
#include <functional>
#include <fmt/core.h>
#include <glob.h>
#include <unistd.h>
#include "base/error.h"
#include "base/radopts.h"
#include "base/run.h"
#include "base/warnings.h"
#include "comfort/columns.h"

namespace {
using base::Words;

struct Row {
    const char* name;
    const char* args;
    const char* help;
    std::function<void(Words&)> read;  // none: another reader's (the view's), or a question
};

std::vector<std::string> split(const std::string& list) {
    std::vector<std::string> out;
    for (size_t at = 0; at <= list.size();) {
        const size_t comma = std::min(list.find(',', at), list.size());
        if (comma > at) out.push_back(list.substr(at, comma - at));
        at = comma + 1;
    }
    return out;
}

// A column or row, possibly outside the picture.
int pixel(Words& w, const char* name) {
    const long n = w.next_int(name);
    if (std::labs(n) > 1 << 20) base::fail(name, std::to_string(n) + " is no pixel of a picture");
    return int(n);
}

comfort::Circle circle(Words& w, const char* name) {
    comfort::Circle c;
    c.x = pixel(w, name);
    c.y = pixel(w, name);
    c.opening = w.next_real(name);
    if (!(c.opening > 0)) base::fail(name, "the opening angle must be above 0");
    return c;
}

int choice(Words& w, const char* name, int low, int high) {
    const long n = w.next_int(name);
    if (n < low || n > high) base::fail(name, fmt::format("{} is not one of {} to {}", n, low, high));
    return int(n);
}

void like(Options& o, const std::string& word) {
    if (word == "evalglare") {
        o.like = Like::evalglare;
        o.settings.slips = true;
    } else if (word == "accelerad") {  // AcceleradRT: every bright pixel, older position index, always corrected
        o.like = Like::accelerad;
        o.format = comfort::TableFormat::csv;
        o.settings.dgp_form = comfort::DgpForm::pixel;
        o.settings.position = comfort::PositionModel::accelerad;
        o.settings.low_light = true;
        o.settings.rammg_area = comfort::RammgArea::prototype_scale;
    } else {
        base::fail("-like", "\"" + word + "\" is neither evalglare nor accelerad");
    }
}

void dgp_definition(Options& o, const std::string& word) {
    if (word == "evalglare") o.settings.dgp_form = comfort::DgpForm::merged, o.settings.constants = {};
    else if (word == "paper") o.settings.constants = comfort::paper_dgp;
    else if (word == "pixel") o.settings.dgp_form = comfort::DgpForm::pixel;
    else base::fail("-dgp", "\"" + word + "\" is none of evalglare, paper, pixel");
}

void rammg_definition(Options& o, const std::string& word) {
    if (word == "view") o.settings.rammg_area = comfort::RammgArea::view;
    else if (word == "rect") o.settings.rammg_area = comfort::RammgArea::rectangle;
    else if (word == "interior") o.settings.rammg_area = comfort::RammgArea::interior;
    else if (word == "prototype") o.settings.rammg_area = comfort::RammgArea::prototype_scale;
    else base::fail("-rammg", "\"" + word + "\" is none of view, rect, interior, prototype");
}

void format(Options& o, const std::string& word) {
    if (word == "tsv") o.format = comfort::TableFormat::tsv;
    else if (word == "csv") o.format = comfort::TableFormat::csv;
    else if (word == "jsonl") o.format = comfort::TableFormat::jsonl;
    else base::fail("-format", "\"" + word + "\" is none of tsv, csv, jsonl");
}

void weights(Options& o, Words& w) {
    comfort::DgpConstants& k = o.settings.constants;
    for (double* v : {&k.a1, &k.a2, &k.a3, &k.a4, &k.a5, &k.c1, &k.c2, &k.c3}) *v = w.next_real("-w");
}

void correction(Options& o, const std::string& word) {
    if (word == "l+") o.settings.low_light = true;
    if (word == "l-" || word == "0") o.settings.low_light = false;
}

[[noreturn]] void rewrites(const char* name) {
    base::fail(name, "evalglare writes a picture here; vcmetrics only measures (pcomb and pvalue change pictures)");
}

std::vector<Row> table(Options& o) {
    comfort::Settings& s = o.settings;
    return {
        {"-metrics", "list",
         "columns, comma separated: ", [&](Words& w) { o.metrics = split(w.next_string("-metrics")); }},
        {"-regions", "file", "named regions: masks of vcregion(1), or a region file",
         [&](Words& w) { o.regions_file = w.next_string("-regions"); }},
        {"-cr", "pair", "contrast ratio of two regions: low/high or name=low/high; may be repeated",
         [&](Words& w) {
             for (const std::string& p : split(w.next_string("-cr"))) o.contrast_pairs.push_back(p);
         }},
        {"-task", "name", "region that sets the threshold: 5 times its mean luminance",
         [&](Words& w) { s.task_region = w.next_string("-task"); }},
        {"-sources", "", "a line for each glare source in place of the metrics",
         [&](Words&) { o.list_sources = true; }},
        {"-format", "name", "tsv (default), csv, jsonl", [&](Words& w) { format(o, w.next_string("-format")); }},
        {"-until", "rule", "stop when it holds, for example 'DGP 1%, Ev 0.5%'",
         [&](Words& w) { o.until = w.next_string("-until"); }},
        {"-window", "n", "lines over which the rule of -until must hold (10)",
         [&](Words& w) { o.window = choice(w, "-window", 2, 1000000); }},
        {"-compare", "",
         "compare two inputs: pictures, streams, recorded tables or evalglare's lines; status 5 when out of tolerance",
         [&](Words&) { o.compare = true; }},
        {"-tolerance", "rules", "for -compare: 'DGP 0.01, Ev 1%, all 2%', or a file of such lines",
         [&](Words& w) { o.tolerances = w.next_string("-tolerance"); }},
        {"-like", "program", "speak as evalglare or accelerad does",
         [&](Words& w) { like(o, w.next_string("-like")); }},
        {"-dgp", "form", "DGP as evalglare (default), paper (constants), pixel (no merging)",
         [&](Words& w) { dgp_definition(o, w.next_string("-dgp")); }},
        {"-rammg", "area", "RAMMG over view (default), rect, interior, prototype",
         [&](Words& w) { rammg_definition(o, w.next_string("-rammg")); }},
        {"-vf", "file", "view from a view file or a picture",
         [&](Words& w) { o.view = view::read_view_file(w.next_string("-vf")); }},
        {"-vt", "T", "view type, joined: v a h s c; a view given here replaces the header's", {}},
        {"-vp", "x y z", "view point", {}},
        {"-vd", "x y z", "view direction", {}},
        {"-vu", "x y z", "view up", {}},
        {"-vh", "a", "horizontal size, degrees", {}},
        {"-vv", "a", "vertical size, degrees", {}},
        {"-vo", "d", "fore clipping distance", {}},
        {"-va", "d", "aft clipping distance", {}},
        {"-vs", "f", "shift", {}},
        {"-vl", "f", "lift", {}},
        {"-b", "factor", "threshold: factor of the task's or mean luminance, above 100 cd/m2 (2000; 5 with a task)",
         [&](Words& w) { s.threshold = w.next_real("-b"); }},
        {"-t", "x y angle", "task area: pixel (y from the bottom), opening angle in radians",
         [&](Words& w) { s.task = circle(w, "-t"); }},
        {"-T", "x y angle", "the same", [&](Words& w) { s.task = circle(w, "-T"); }},
        {"-r", "angle", "search radius between pixels of one source, radians (0.2)",
         [&](Words& w) {
             s.search_opening = w.next_real("-r");
             if (!(s.search_opening > 0)) base::fail("-r", "the radius must be above 0");
         }},
        {"-s", "", "smooth sources", [&](Words&) { s.smooth = true; }},
        {"-y", "", "extract peaks (default)", [&](Words&) { s.peaks = true; }},
        {"-Y", "lum", "extract peaks from this luminance on (50000)",
         [&](Words& w) {
             s.peaks = true;
             s.peak_limit = w.next_real("-Y");
         }},
        {"-x", "", "extract no peaks", [&](Words&) { s.peaks = false; }},
        {"-G", "type", "cut the field of view: 1 total, 2 both eyes, 3 weighted",
         [&](Words& w) { s.field_cut = choice(w, "-G", 1, 3); }},
        {"-q", "mode", "background luminance: 0 from Ev - Edir (default), 1 without sources, 2 from Ev",
         [&](Words& w) { s.background = choice(w, "-q", 0, 2); }},
        {"-C", "what", "low light correction: l+ on, l- or 0 off (default)",
         [&](Words& w) { correction(o, w.next_string("-C")); }},
        {"-i", "Ev", "external illuminance for DGP, lux", [&](Words& w) { s.external_ev = w.next_real("-i"); }},
        {"-I", "Ev ymax ymin", "the same, and fill rows from ymax up and from ymin down",
         [&](Words& w) {
             s.external_ev = w.next_real("-I");
             comfort::Fill f;
             f.y_max = pixel(w, "-I");
             f.y_min = pixel(w, "-I");
             s.fill = f;
         }},
        {"-k", "lum", "leave out terms of Lveil up to this", [&](Words& w) { s.veil_cut = w.next_real("-k"); }},
        {"-P", "model", "position index: 0 Guth (default), 1 KIM",
         [&](Words& w) {
             s.position = choice(w, "-P", 0, 1) ? comfort::PositionModel::kim : comfort::PositionModel::guth;
         }},
        {"-w", "a1 a2 a3 a4 a5 c1 c2 c3", "constants of DGP (see the page)", [&](Words& w) { weights(o, w); }},
        {"-z", "angle mode", "fixed patches, degrees; mode 1 metrics, 3 coefficients",
         [&](Words& w) {
             comfort::Patches p;
             p.angle_deg = w.next_real("-z");
             p.mode = choice(w, "-z", 1, 3);
             s.patches = p;
             if (p.mode == 3) like(o, "evalglare");
         }},
        {"-l", "x y angle", "zone of the task",
         [&](Words& w) {
             s.zones = comfort::Zones{circle(w, "-l"), {}};
         }},
        {"-L", "x y angle1 angle2", "two zones",
         [&](Words& w) {
             s.zones = comfort::Zones{circle(w, "-L"), {}};
             s.zones->outer_opening = w.next_real("-L");
         }},
        {"-A", "file", "statistics of a mask picture, PGSV", [&](Words& w) { s.mask_file = w.next_string("-A"); }},
        {"-B", "angle", "statistics of a horizontal band, half height in radians",
         [&](Words& w) { s.band_rad = w.next_real("-B"); }},
        {"-f", "", "measure a perspective picture with black corners all the same", [&](Words&) { s.force = true; }},
        {"-d", "", "evalglare's detailed lines (implies -like evalglare)",
         [&](Words&) {
             like(o, "evalglare");
             o.evalglare.detailed = true;
         }},
        {"-D", "", "evalglare's line with Ev (implies -like evalglare)",
         [&](Words&) {
             like(o, "evalglare");
             o.evalglare.dgp_and_ev = true;
         }},
        {"-V", "", "evalglare's line of Ev alone, status 1 (implies -like evalglare)",
         [&](Words&) {
             like(o, "evalglare");
             o.evalglare.ev_only = true;
         }},
        {"-1", "", "evalglare's fast DGP of -i Ev (implies -like evalglare)",
         [&](Words&) {
             like(o, "evalglare");
             s.fast = 1;
         }},
        {"-2", "Edir", "evalglare's fast DGP and UGR (implies -like evalglare)",
         [&](Words& w) {
             like(o, "evalglare");
             s.fast = 2;
             s.fast_direct = w.next_real("-2");
         }},
        {"-3", "", "evalglare's third fast mode: nothing is printed (implies -like evalglare)",
         [&](Words&) {
             like(o, "evalglare");
             s.fast = 3;
         }},
        {"-4", "", "no low light correction", [&](Words&) { s.low_light = false; }},
        {"-u", "r g b", "colour of sources in a check picture: no effect",
         [&](Words& w) {
             for (int k = 0; k < 3; ++k) w.next_real("-u");
         }},
        {"-a", "age", "gone from evalglare: an error",
         [](Words&) { base::fail("-a", "the age factor is gone from evalglare, and not supported here"); }},
        {"-c", "file", "not here: writes a check picture", [](Words&) { rewrites("-c"); }},
        {"-m", "...", "not here: rewrites the picture", [](Words&) { rewrites("-m"); }},
        {"-M", "...", "not here: rewrites the picture", [](Words&) { rewrites("-M"); }},
        {"-N", "...", "not here: rewrites the picture", [](Words&) { rewrites("-N"); }},
        {"-O", "...", "not here: rewrites the picture", [](Words&) { rewrites("-O"); }},
        {"-p", "...", "not here: writes the position index", [](Words&) { rewrites("-p"); }},
        {"-g", "type", "not here: writes the field of view (-G measures it)", [](Words&) { rewrites("-g"); }},
        {"-Q", "...", "not here: several pictures pasted into one",
         [](Words&) {
             base::fail("-Q",
                        "evalglare's several-pictures mode is not here; vcmetrics reads any number of pictures one "
                        "after another");
         }},
        {"-v", "", "print the version", {}},
        {"-W", "+-", "warnings", {}},
        {"-version", "", "print the version", {}},
        {"-help", "", "print this list", {}},
    };
}

void print(const std::string& text) { base::write_stdout(text.data(), text.size()); }

void print_help(Options& o) {
    std::string text = "usage: vcmetrics [options] [picture ...]\n";
    for (const Row& row : table(o)) {
        const std::string name = row.name;
        const std::string left = name + (name == "-W"    ? "[+-]"
                                         : name == "-vt" ? "T"
                                         : *row.args     ? std::string(" ") + row.args
                                                         : "");
        text += fmt::format("  {:<28} {}\n", left, row.help + (name == "-metrics" ? comfort::column_names() : ""));
    }
    print(text + "One-letter options are evalglare's.  Described in vcmetrics(1).\n");
}

// Command line views start afresh: type and both sizes must be given.
struct ViewWords {
    view::View view;
    bool any = false, type = false, vh = false, vv = false;
};

void expand_globs(std::vector<std::string>& files) {
    std::vector<std::string> out;
    for (const std::string& f : files) {
        glob_t found = {};
        if (f.find_first_of("*?[") != std::string::npos && access(f.c_str(), F_OK) != 0 &&
            glob(f.c_str(), 0, nullptr, &found) == 0)
            out.insert(out.end(), found.gl_pathv, found.gl_pathv + found.gl_pathc);
        else out.push_back(f);
        globfree(&found);
    }
    files.swap(out);
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, Options& o) {
    Words words(std::vector<std::string>(argv + 1, argv + argc));
    const std::vector<Row> rows = table(o);
    ViewWords v;
    bool loud = true;
    const auto read_one = [&] {
        for (const Row& row : rows)
            if (row.read && words.is(row.name)) {
                row.read(words);
                return true;
            }
        return false;
    };
    while (words.more()) {
        std::string word = words.peek();
        if (word.compare(0, 2, "--") == 0 && word.size() > 3) word.erase(0, 1);
        if (word == "-help") {
            print_help(o);
            return 0;
        }
        if (word == "-version" || word == "-v") {
            print("vcmetrics " LUXPIPE_VERSION "\n");
            return 0;
        }
        if (words.is_switch("-W", loud)) {
            if (!loud) base::set_warning_sink({});
            continue;
        }
        if (read_one()) continue;
        if (const int n = view::parse_option(v.view, words.all(), words.at())) {
            v.any = true;
            v.type |= word.compare(0, 3, "-vt") == 0;
            v.vh |= word == "-vh";
            v.vv |= word == "-vv";
            words.skip(n);
        } else if (words.is_option()) {
            base::fail(words.peek(), "is no option; vcmetrics -help lists them");
        } else {
            o.files.push_back(words.take());
        }
    }
    if (v.any) {
        if (!v.type || !v.vh || !v.vv)
            base::fail("view",
                       "a view on the command line replaces the picture's own and needs at least -vt, -vh and -vv");
        o.view = v.view;
    }
    if (o.settings.mask_file && o.settings.zones) base::fail("-A", "a mask and zones (-l, -L) exclude each other");
    if (o.like != Like::vcmetrics && !o.compare && (o.list_sources || !o.metrics.empty()))
        base::fail("-like", "has its own columns: no -metrics, no -sources");
    if (o.like != Like::vcmetrics && !o.until.empty())
        base::fail("-until", "works with vcmetrics' own columns: not with -like");
    if (o.list_sources && !o.until.empty()) base::fail("-until", "works on metrics: not with -sources");
    expand_globs(o.files);
    if (o.compare && o.files.size() != 2)
        base::fail("-compare", fmt::format("compares two inputs, not {}", o.files.size()));
    if (o.compare &&
        (!o.until.empty() || o.list_sources || (o.like == Like::evalglare && (o.evalglare.ev_only || o.settings.fast))))
        base::fail("-compare", "works on tables of metrics: not with -until, -sources, -V, -1, -2 or -3");
    return std::nullopt;
}
