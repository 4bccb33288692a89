// SPDX-License-Identifier: BSD-3-Clause
// See page_parts.h; the sources of the rules are in docs/en17037.md.
#include "year/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/text_file.h"
#include "year/en17037_text.h"
#include "year/text.h"

namespace year {
namespace {

using base::escaped;

struct Part {
    std::string name, of, level;
    std::optional<int> worst;  // the lower limit of the level, where there is one
    std::string value, rule, next;
};

std::string row_of(const Part& p) {
    const std::string level_class = p.worst ? fmt::format(" class=\"class{}\"", highest_level - *p.worst) : "";
    return fmt::format("<tr><td>{}<small>{}</small></td><td{}>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>\n", p.name,
                       escaped(p.of), level_class, p.level, p.value, p.rule, p.next);
}

// "300 lx on 50 % of the sensors and 100 lx on 95 %".
std::string demand_words(int level, bool rooflight) {
    std::string text;
    for (const Demand& d : demands(level, rooflight))
        text += fmt::format("{}{:g} lx on {:g} %{}", text.empty() ? "" : " and ", provision_lux[d.lux], 100 * d.share,
                            text.empty() ? " of the sensors" : "");
    return text;
}

std::string provision_rule(bool rooflight, size_t hours, const std::string& file, const std::string& shades) {
    std::string text;
    for (int level = 1; level <= highest_level; ++level)
        text += fmt::format("{}: {}; ", level_name(level), demand_words(level, rooflight));
    text += fmt::format("each in half of {} daylight hours", hours ? std::to_string(hours) : "the 4380");
    if (!file.empty()) text += ", those of most diffuse light in " + escaped(file.substr(file.rfind('/') + 1));
    return text + "." + (shades.empty() ? "" : " Shades: " + escaped(shades) + ".");
}

Part part_of(const PageParts::Plane& plane, const std::string& file) {
    const Provision& p = plane.provision;
    std::string value;
    for (const Demand& d : demands(std::max(p.level, 1), p.rooflight))
        value += fmt::format("{}{:g} lx on {}", value.empty() ? "" : "<br>", provision_lux[d.lux],
                             percent_text(p.plane[d.lux]));
    return {"Daylight provision",
            fmt::format("{}, {} sensors", plane.name, p.sensors.size()),
            level_words(p.low, p.high),
            p.low,
            value,
            provision_rule(p.rooflight, p.hours, file, plane.shades),
            p.low < highest_level ? "for " + lacks_words(p, p.low + 1) : "&ndash;"};
}

constexpr const char* sunlight_rule =
    "minimum: the sun, from {} on, reaches a point of the openings for 1.5 h; medium: 3 h; high: 4 h, on a cloudless "
    "day from 1 February to 21 March.";

Part part_of(const PageParts::Openings& openings) {
    const Sunlight& s = openings.sunlight;
    std::string next = "&ndash;";
    if (s.low < highest_level)
        next = fmt::format("for {}: {:.2f} h more", level_name(s.low + 1), sunlight_hours[size_t(s.low)] - s.hours.low);
    return {"Exposure to sunlight",
            openings.name,
            level_words(s.low, s.high),
            s.low,
            fmt::format("{} on {}", sun_hours_words(s.hours), day_text(s.date)),
            fmt::format(sunlight_rule, fmt::format("{:g}° of height", s.lowest_deg)) +
                fmt::format(" Steps of {:g} min.", s.step_min),
            next};
}

// Of the view of most glare.
Part part_of(const std::vector<Verdict>& verdicts) {
    const auto least = [](const Verdict& a, const Verdict& b) { return a.exceeded.value < b.exceeded.value; };
    const Verdict& v = *std::max_element(verdicts.begin(), verdicts.end(), least);
    const size_t allowed = size_t(exceeding_share * double(v.hours) + 1e-9);
    std::string next = "&ndash;";
    if (v.worst > 0) {
        const size_t k = size_t(v.worst - 1);
        next = fmt::format("for {}: {:.0f} hours fewer above {:.2f}", class_name(int(k)),
                           std::max(1., v.above[k].high - double(allowed)), limits[k]);
    }
    const std::string many = verdicts.size() > 1 ? fmt::format(", the worst of {} views", verdicts.size()) : "";
    return {
        "Protection from glare",
        (v.view.empty() ? "the view" : v.view) + many,
        level_words(highest_level - v.worst, highest_level - v.best),
        highest_level - v.worst,
        fmt::format("DGPe5 {:.3f} ({:.3f} to {:.3f})", v.exceeded.value, v.exceeded.low, v.exceeded.high),
        fmt::format("at most 5 % of the {} hours counted, {} of them, have a DGP above, minimum: 0.45; medium: 0.40; "
                    "high: 0.35.",
                    v.hours, allowed),
        next};
}

constexpr double sight_degrees[highest_level] = {14, 28, 54};  // minimum, medium, high
constexpr const char* view_rule =
    "openings take, of the horizon around a point of the used area, minimum: 14°; medium: 28°; high: 54°. "
    "Medium also asks that what stands opposite is more than 20 m away and that landscape and sky or ground are seen, "
    "from 75 % of the area.";

Part part_of(const ViewOut& v) {
    int most = 0;
    while (most < highest_level && v.sight_deg >= sight_degrees[most]) ++most;
    std::string seen;
    for (const std::string& name : v.seen) seen += (seen.empty() ? "" : ", ") + escaped(name);
    std::string next = most < highest_level ? fmt::format("for {}: {:.1f}° more; ", level_name(most + 1),
                                                          sight_degrees[most] - v.sight_deg)
                                            : "";
    return {"View out",
            "one point",
            std::string(most > 0 ? "at most " : "") + level_name(most),
            {},
            fmt::format("{:.1f}° of the horizon", v.sight_deg) + (seen.empty() ? "" : "<br>seen: " + seen),
            view_rule,
            next + "distance, layers and other points are the planner's to say"};
}

Part absent(const char* name, const std::string& rule) {
    return {name, "", "not counted", {}, "&ndash;", rule, "&ndash;"};
}

}  // namespace

ViewOut read_view_out(const std::string& path) {
    constexpr size_t longest = size_t(1) << 20, share = 3;
    ViewOut out;
    bool has_opening = false;
    for (const std::string& line : base::split_list(base::read_text_file(path, longest), '\n')) {
        const std::vector<std::string> cells = base::split_list(line, '\t');
        double of_view = 0;
        if (cells.size() <= share || cells[0] == "region") continue;
        if (!base::parse_real(cells[share], of_view)) base::fail(path, "is not what vcregion -list prints");
        if (cells[0] == "opening") out.sight_deg = 360 * of_view, has_opening = true;
        else out.seen.push_back(cells[0]);
    }
    if (!has_opening) base::fail(path, "has no region \"opening\" (vcregion -list)");
    return out;
}

std::string parts_table(const PageParts& parts, const std::vector<Verdict>& verdicts, double certainty) {
    std::string out =
        "<table class=\"parts\"><thead><tr><th>Part of EN 17037</th><th>Level</th><th>Value</th><th>Rule</th>"
        "<th>To the next level</th></tr></thead><tbody>\n";
    for (const PageParts::Plane& p : parts.planes) out += row_of(part_of(p, parts.daylight_hours));
    if (parts.planes.empty()) out += row_of(absent("Daylight provision", provision_rule(false, 0, "", "")));
    for (const PageParts::Openings& o : parts.openings) out += row_of(part_of(o));
    if (parts.openings.empty())
        out += row_of(
            absent("Exposure to sunlight", fmt::format(sunlight_rule, "a height that the norm has for the place")));
    out += row_of(parts.view_out ? part_of(*parts.view_out) : absent("View out", view_rule));
    out += row_of(part_of(verdicts));
    return out + fmt::format(
                     "</tbody></table>\n<p class=\"note\">In brackets: the {:g} % interval. A level is undecided "
                     "where the interval reaches over its limit. The rules are those of public sources on the "
                     "norm (docs/en17037.md of luxpipe); its own text is sold and was not read.</p>\n",
                     100 * certainty);
}

}  // namespace year
