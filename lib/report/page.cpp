// SPDX-License-Identifier: BSD-3-Clause
// See page.h.
#include "report/page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/printable.h"
#include "base/angle.h"
#include "glare/columns.h"
#include "report/page_about.h"
#include "report/page_figures.h"
#include "report/page_style.h"
#include "report/table.h"
#include "report/verdict_words.h"

namespace report {

using base::escaped;

namespace {

constexpr size_t most_sources = 12;

struct MetricName {
    const char *name, *words, *unit;
};
constexpr MetricName of_metrics[] = {
    {"Ev", "Illuminance at the eye", "lx"},
    {"DGPf", "Daylight glare probability", ""},
    {"DGP", "Daylight glare probability, by whole pixels", ""},
    {"DGPu", "Daylight glare probability, by whole pixels, without the bias of noise", ""},
    {"DGP.px", "What the size of the pixels adds to it", ""},
    {"UGR", "Unified glare rating, by whole pixels", ""},
    {"UGRf", "Unified glare rating", ""},
    {"DGI", "Daylight glare index, by whole pixels", ""},
    {"DGIf", "Daylight glare index", ""},
    {"VCP", "Visual comfort probability, by whole pixels", "%"},
    {"Edir", "Illuminance at the eye from glare sources", "lx"},
    {"Lavg", "Mean luminance", "cd/m²"},
    {"Lmax", "Largest luminance", "cd/m²"},
    {"Lmed", "Median luminance", "cd/m²"},
    {"Lb", "Luminance of the background", "cd/m²"},
    {"RAMMG", "Contrast of neighbouring pixels, over all sizes of detail", "cd/m²"},
    {"n_sources", "Glare sources", ""},
    {"mEDI", "Melanopic equivalent daylight illuminance at the eye", "lx"},
    {"mDER", "Melanopic daylight efficacy ratio", ""},
    {"EvV", "Illuminance at the eye, by V", "lx"},
};
constexpr MetricName of_regions[] = {
    {"TAL", "Mean luminance of ", "cd/m²"},
    {"mean", "Mean luminance of ", "cd/m²"},
    {"median", "Median luminance of ", "cd/m²"},
    {"min", "Least luminance of ", "cd/m²"},
    {"max", "Largest luminance of ", "cd/m²"},
    {"share", "Share of the view: ", ""},
    {"CR", "Contrast ratio (above 0.25 reflections are intolerable): ", ""},
};
constexpr MetricName of_grids[] = {
    {"mean", "Mean illuminance of ", "lx"},         {"min", "Least illuminance of ", "lx"},
    {"max", "Largest illuminance of ", "lx"},       {"median", "Median illuminance of ", "lx"},
    {"U0", "Uniformity (least over mean) of ", ""}, {"df", "Daylight factor of ", "%"},
};

// What a column is, and its unit.
std::pair<std::string, std::string> words_of(const std::string& column) {
    for (const MetricName& w : of_metrics)
        if (column == w.name) return {w.words, w.unit};
    const size_t dot = column.rfind('.');
    for (const MetricName& w : of_regions)
        if (dot != std::string::npos && column.substr(dot + 1) == w.name)
            return {w.words + column.substr(0, dot), w.unit};
    return {column, ""};
}

// A number as vcmetrics prints it, and what a person reads.
std::string data(double value, const std::string& shown) {
    return fmt::format("<data value=\"{}\">{}</data>", number_cell(value).text, shown);
}
// To three digits.
std::string data(double value) { return data(value, rounded(value, std::fabs(value) / 10)); }
std::string percent(double share) { return data(share, fmt::format("{:.0f} %", 100 * share)); }

// For rounding: to no more than four digits.
double half_width(const Page::Number& n) { return std::max(std::fabs(n.value) / 100, (n.high - n.low) / 2); }
std::string value_text(const Page::Number& n) { return data(n.value, rounded(n.value, half_width(n))); }
std::string interval_text(const Page::Number& n) {
    if (!std::isfinite(n.low) || !std::isfinite(n.high)) return "";
    return data(n.low, rounded(n.low, half_width(n))) + " to " + data(n.high, rounded(n.high, half_width(n)));
}

std::string verdict(const Page& page) {
    if (page.is_black) return fmt::format("<p class=\"verdict\">The picture is black: {}.</p>\n", glare::why_black);
    const Page::Number* dgp = nullptr;
    for (const char* const name : {"DGPf", "DGPu", "DGP"})
        for (const Page::Number& n : page.numbers)
            if (!dgp && n.name == name && std::isfinite(n.value)) dgp = &n;
    if (!dgp) return "<p class=\"verdict\">DGP is not among the numbers.</p>\n";
    const bool known = std::isfinite(dgp->low) && std::isfinite(dgp->high);
    const VerdictWords said = verdict_words(dgp->value, dgp->low, dgp->high);
    std::string out = said.words.empty()
                          ? "<div class=\"verdict\"><p class=\"words\">The class of glare is not known yet</p>\n"
                          : fmt::format("<div class=\"verdict class{}\"><p class=\"words\">Glare is {}</p>\n",
                                        said.worst, said.words);
    out += fmt::format("<p>{} {}", dgp->name, value_text(*dgp));
    if (known) out += fmt::format(" ({:g} % interval: {})", 100 * page.certainty, interval_text(*dgp));
    out += ". " + said.people;
    return out + "</p>\n" + dgp_bar(*dgp) + "</div>\n";
}

std::string body_clock(const Page& page) {
    const auto edi = std::find_if(page.numbers.begin(), page.numbers.end(),
                                  [](const Page::Number& n) { return n.name == "mEDI" && std::isfinite(n.value); });
    if (edi == page.numbers.end()) return "";
    const std::string interval = interval_text(*edi);
    return fmt::format("<p class=\"clock\">Daylight for the body clock: {} lx of melanopic EDI{}.</p>\n",
                       value_text(*edi), interval.empty() ? "" : " (" + interval + ")");
}

// "26 November 2026", of CAPDATE= 2026:11:26 04:01:25.
std::string date_of(const Page& page) {
    int year = 0, month = 0, day = 0;
    for (const std::string& line : page.header.lines)
        if (std::sscanf(line.c_str(), "CAPDATE= %d:%d:%d", &year, &month, &day) == 3 && month >= 1 && month <= 12)
            return fmt::format("{}{} {} {}", page.title.empty() ? "" : ", ", day, month_word(month), year);
    return "";
}

// share300 of a grid is that of its points at 300 lx or more.
std::pair<std::string, std::string> words_of_grid(const std::string& column) {
    const size_t dot = column.rfind('.');
    const std::string grid = column.substr(0, dot), what = column.substr(dot + 1);
    for (const MetricName& w : of_grids)
        if (what == w.name) return {w.words + grid, w.unit};
    if (what.rfind("share", 0) == 0)
        return {"Share of the points of " + grid + " at " + what.substr(5) + " lx or more", ""};
    return {column, "lx"};
}

using WordsOf = std::pair<std::string, std::string>(const std::string& column);
std::string numbers(const Page& page, const char* title, const std::vector<Page::Number>& all, WordsOf& words_of) {
    std::string out = fmt::format(
        "<h2>{1}</h2>\n<table class=\"numbers\"><thead><tr><th></th><th></th><th>Value</th>"
        "<th>{0:g} % interval</th><th></th></tr></thead><tbody>\n",
        100 * page.certainty, title);
    for (const Page::Number& n : all) {
        const auto [words, unit] = words_of(n.name);
        if (!std::isfinite(n.value)) {  // a region that is out of sight, or what needs moments of pixels
            out += fmt::format("<tr><td>{}</td><td>{}</td><td>not known</td><td></td><td></td></tr>\n", escaped(words),
                               words == n.name ? "" : escaped(n.name));
            continue;
        }
        out += fmt::format("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", escaped(words),
                           words == n.name ? "" : escaped(n.name), value_text(n), interval_text(n), unit);
    }
    return out + "</tbody></table>\n";
}

std::string side(double degrees, const char* positive, const char* negative) {
    return fmt::format("{:.0f}° {}", std::fabs(degrees), degrees < 0 ? negative : positive);
}

std::string sources(const Page& page) {
    std::string out = "<h2>Glare sources</h2>\n";
    if (page.sources.empty()) return out + "<p>There is no glare source in this view.</p>\n";
    const view::Projector eye(page.view);
    out += fmt::format(
        "<table class=\"sources\"><thead><tr><th>No.</th><th>Share of DGP</th>{}<th>Where</th><th>cd/m²</th>"
        "<th>sr</th><th>Position index</th><th>lx at the eye</th></tr></thead><tbody>\n",
        page.knows_objects ? "<th>What</th>" : "");
    std::vector<Page::Source> all = page.sources;
    std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
    size_t shown = 0;
    for (; shown < all.size() && shown < most_sources && (all[shown].share >= speck || shown == 0); ++shown) {
        const Page::Source& s = all[shown];
        const base::Vec3 d = s.direction;
        const double right = std::atan2(base::dot(d, eye.right()), base::dot(d, eye.forward())) / base::degree;
        const double up = std::asin(std::clamp(base::dot(d, eye.up()), -1., 1.)) / base::degree;
        out += fmt::format(
            "<tr><td>{}</td><td>{}</td>{}<td>{}<br>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n",
            s.number, percent(s.share), page.knows_objects ? "<td class=\"what\">" + escaped(s.what) + "</td>" : "",
            side(right, "right", "left"), side(up, "up", "down"), data(s.lum_cdm2), data(s.omega_sr),
            data(s.position_index), data(s.eye_lux));
    }
    double rest = 0;
    for (size_t k = shown; k < all.size(); ++k) rest += all[k].share;
    if (shown < all.size())
        out += fmt::format("<tr><td></td><td>{:.1f} %</td><td colspan=\"6\">{} smaller {}</td></tr>\n", 100 * rest,
                           all.size() - shown, all.size() - shown > 1 ? "ones together" : "one");
    return out +
           "</tbody></table>\n<p class=\"note\">A glare source is a part of the view much brighter than the rest. "
           "Where: "
           "from the line of sight.</p>\n";
}

std::string view_words(const Page& page) {
    const view::View& v = page.view;
    const char* const types[] = {"vperspective", "aangular fisheye", "hhemispherical fisheye", "sstereographic fisheye",
                                 "ccylindrical panorama"};
    std::string type;
    for (const char* const t : types)
        if (t[0] == v.type) type = t + 1;
    const base::Vec3 d = base::unit(v.vd);
    const double north = std::atan2(d.x, d.y) / base::degree;
    return fmt::format(
        "{}, {:g}° by {:g}°, {} by {} pixels; eye at {:g}, {:g}, {:g}; looks {}, {:.0f}° from north (the y axis) "
        "over "
        "east, {}",
        type, v.vh, v.vv, page.width, page.height, v.vp.x, v.vp.y, v.vp.z, compass_word(north),
        north < 0 ? north + 360 : north, side(std::asin(std::clamp(d.z, -1., 1.)) / base::degree, "up", "down"));
}

std::string list(const char* title, const std::vector<std::string>& lines) {
    std::string out;
    for (const std::string& l : lines) out += "<code>" + escaped(l) + "</code>\n";
    return lines.empty() ? "" : fmt::format("<dt>{}</dt><dd>{}</dd>\n", title, out);
}

std::string origin(const Page& page) {
    const image::Header& h = page.header;
    std::vector<std::string> rendering;
    if (!h.fingerprint.empty()) rendering.push_back("fingerprint " + h.fingerprint);
    std::string frames = h.frames ? fmt::format("{} frames", *h.frames) : "";
    if (h.seed) frames += fmt::format("{}seed {}", frames.empty() ? "" : ", ", *h.seed);
    if (!frames.empty()) rendering.insert(rendering.begin(), frames);
    std::string out = "<h2>How it was made</h2>\n<dl>\n";
    out += fmt::format("<dt>View</dt><dd>{}<code>{}</code></dd>\n", escaped(view_words(page)),
                       escaped(view::to_options(page.view)));
    out += list("Sky", page.sky) + list("Rendering", rendering) + list("Commands", page.commands);
    if (!page.files.empty()) {
        out +=
            "<dt>Files</dt><dd><table class=\"files\"><thead><tr><th>Name</th><th>SHA-256</th></tr></thead><tbody>\n";
        for (const Page::File& f : page.files)
            out += fmt::format("<tr><td>{}</td><td>{}</td></tr>\n", escaped(f.name), f.sha256);
        out += "</tbody></table></dd>\n";
    }
    return out + "<dt>Program</dt><dd>" + escaped(page.version) + "</dd>\n</dl>\n";
}

}  // namespace

std::string page_text(const Page& page) {
    std::string out = fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'unsafe-inline'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<title>Glare: {0}</title>\n<style>{1}</style>\n</head>\n<body>\n<section>\n"
        "<h1>Glare report</h1>\n<p class=\"title\">{0}{2}</p>\n",
        escaped(page.title), page_style, date_of(page));
    out += about_list(page) + verdict(page) + body_clock(page);
    for (const std::string& note : page.notes) out += "<p class=\"note\">" + escaped(note) + "</p>\n";
    out += criteria_table(page) + "<div class=\"drawings\">\n";
    for (const Page::Drawing& d : page.drawings) out += drawing(page, d);
    out += "</div>\n" + legend(page.legend) + where_and_when(page) + numbers(page, "Numbers", page.numbers, words_of) +
           "</section>\n<section>\n";
    if (!page.plan.svg.empty())
        out += numbers(page, "Plan", page.plan.numbers, words_of_grid) + plan_maps(page.plan.svg);
    out += variants_and_day(page) + sources(page) + origin(page);
    return out +
           "<p class=\"note\">Intervals cover the noise of the rendering, not the model, the materials, the sky or how "
           "people differ. DGP: Wienold and Christoffersen 2006.</p>\n</section>\n</body>\n</html>\n";
}

}  // namespace report
