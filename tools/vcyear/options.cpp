// SPDX-License-Identifier: BSD-3-Clause
// vcyear's options, each declared once (base/options.h).
#include "options.h"

#include <fmt/format.h>

#include "base/error.h"
#include "base/files_read.h"
#include "base/options.h"
#include "base/warnings.h"
#include "image/stream.h"

namespace {

void declare_goals(base::OptionTable& t, year::Goals& g) {
    t.add("-sda lx percent", "Illuminance of DA and sDA, and the hours in which a sensor has to have it",
          {[&g](base::Arguments& a) {
               g.autonomy_lux = a.real(base::above(0));
               g.autonomy_share = a.real(base::within(0, 100)) / 100;
           },
           [&g] { return fmt::format("{:g} {:g}", g.autonomy_lux, 100 * g.autonomy_share); }});
    t.add("-udi low middle high", "Illuminances from which UDI is supplementary, autonomous and exceeded",
          {[&g](base::Arguments& a) {
               for (double& lux : g.useful_lux) lux = a.real(base::above(0));
               if (!(g.useful_lux[0] < g.useful_lux[1] && g.useful_lux[1] < g.useful_lux[2]))
                   base::fail("-udi", "its illuminances rise");
           },
           [&g] { return fmt::format("{:g} {:g} {:g}", g.useful_lux[0], g.useful_lux[1], g.useful_lux[2]); }});
    t.add("-ase lx hours", "Illuminance of direct sun, and how many hours of it are too many",
          {[&g](base::Arguments& a) {
               g.sun_lux = a.real(base::above(0));
               g.sun_hours = a.real(base::within(0, 8784));
           },
           [&g] { return fmt::format("{:g} {:g}", g.sun_lux, g.sun_hours); }});
}

void declare_report(base::OptionTable& t, Options& o) {
    t.add(
        "-report file",
        "Write a page for people: verdicts, shades and their rules, plan, pictures, days by hours, weather and method",
        o.report);
    t.add("-title words", "Title of the report", o.title).default_text("the place of -wea");
    t.add("-views file", "View file with the views of the table, for the plan of the report; may be repeated", o.eyes);
    t.add("-plan picture", "Plan of the report: a picture of a parallel view from above", o.plan);
    t.add("-pictures file", "Picture of an hour for the report (ptaccum -o %s.exr); may be repeated", o.pictures);
    t.add("-plane file", "Table of sensors for the daylight provision of the report (-en17037)", o.planes);
    t.add("-openings file", "Table of points of openings for the sunlight of the report (-sunlight)", o.openings);
    t.add("-viewout file", "What vcregion -list printed of the region opening, for the view out of the report",
          o.view_out);
    t.add("-wea file", "Weather file that the report names, with its source and its comments", o.weather);
}

void check_report(const Options& o) {
    const std::pair<const char*, bool> of_report[] = {
        {"-title", !o.title.empty()},       {"-views", !o.eyes.empty()},   {"-plan", !o.plan.empty()},
        {"-pictures", !o.pictures.empty()}, {"-plane", !o.planes.empty()}, {"-openings", !o.openings.empty()},
        {"-viewout", !o.view_out.empty()},  {"-wea", !o.weather.empty()}};
    for (const auto& [name, given] : of_report)
        if (given && o.report.empty()) base::fail(name, "is of a report (-report)");
    if (!o.planes.empty() && o.en17037.empty()) base::fail("-plane", "needs the weather file of the year (-en17037)");
    if (!o.openings.empty() && o.sun_steps.empty())
        base::fail("-openings", "needs the day and the lowest sun (-sunlight)");
}

}  // namespace

std::optional<int> parse_options(int argc, char** argv, Options& o) {
    base::OptionTable t("vcyear", LUXPIPE_VERSION, "[options] table.tsv ... (\"-\": stdin)");
    t.group("What is printed");
    t.add("-format name", "Form of the numbers: text, tsv, csv or jsonl",
          base::one_of(o.format, {{"text", std::optional<report::TableFormat>()},
                                  {"tsv", report::TableFormat::tsv},
                                  {"csv", report::TableFormat::csv},
                                  {"jsonl", report::TableFormat::jsonl}}));
    t.add("-ci percent", "Probability that an interval holds the truth", o.percent).within(50, 99.9);
    t.add("-view name", "Only this view", o.view).default_text("all");
    t.add("-months", "A row for each month", o.months);
    t.add("-worst n", "Print the n worst hours of each view, with a command that shows each", o.worst).at_least(0);
    t.add("-command words", "Command that shows a view's hours, without -hours", o.command);
    t.add("-next", "Print the hours to render again so that the class is decided, with their frames and size", o.next);
    t.group("Shades");
    t.add("-shades rules", "Which state shades have in each hour: rules, or a file of them", o.shades);
    t.add("-by file", "Table of views that rules read in place of the tables that are counted", o.by);
    t.add("-moves file", "Write a table of the state in each hour, and of the rule that closes shades", o.moves);
    t.add("-state name", "Only this state", o.state).default_text("all");
    t.add("-closed file", "Table of the same views with closed shades, for the hours in which a view is above -close",
          o.closed);
    t.add("-close dgp", "DGP with open shades above which they are closed", o.close_dgp).within(0, 1);
    t.group("Sensors");
    declare_goals(t, o.goals);
    t.add("-direct file", "Table of the same sensors under direct sun alone (ptrace -ab 0), for ASE", o.direct);
    t.add("-each", "A row for each sensor", o.each);
    t.add("-overcast file lux",
          "Table of the same sensors under an overcast sky, and its illuminance outdoors, for the mean daylight factor",
          [&o](base::Arguments& a) {
              o.overcast = a.text();
              o.outdoor_lux = a.real(base::above(0));
          });
    t.add("-leed", "Points of LEED v4.1, option 1, over all grids", o.leed);
    t.group("EN 17037");
    t.add("-en17037 file", "Weather file of the year, for the daylight provision of sensors", o.en17037);
    t.add("-rooflight[+-]", "The daylight openings are horizontal", o.rooflight);
    t.add("-sunlight file degrees", "Sunlight at points of openings: the weather file of the table, the lowest sun",
          [&o](base::Arguments& a) {
              o.sun_steps = a.text();
              o.lowest_deg = a.real(base::within(0, 90));
          });
    t.group("Files");
    t.add("-plot file", "Write a heat map of days by hours, or maps of sensors, .svg or .png", o.plot);
    t.add("-points file", "The points of a grid that ptrace had, for -plot", o.points);
    declare_report(t, o);
    t.add("-honeybee folder", "Write results as honeybee-radiance reads them", o.honeybee);
    t.group("Messages");
    t.add("-w[+-]", "Warnings", o.warnings);
    t.examples(R"(In the folder examples/scenes/office, whose days.wea has a day of each season:
  ptrace -wea days.wea -x 32 -y 32 -vf view.vf materials.rad layout.rad | ptaccum -every x2/8 |
      vcmetrics -metrics Ev,DGPf,DGP.px,DGPf.px,pixels -ci 95 -last > days.tsv
  vcyear days.tsv
  vcyear -worst 3 -plot days.svg days.tsv
)");
    t.options_come_before("the tables");
    const auto operands = t.parse(argc, argv);
    if (!operands) return 0;
    o.tables = *operands;
    if (o.tables.empty()) base::fail("", "no table; vcyear -help lists the options");
    if (o.next && o.worst > 0) base::fail("-next", "prints other lines than -worst; ask for one of them");
    if (!o.sun_steps.empty() && !o.en17037.empty() && o.report.empty())
        base::fail("-sunlight", "has tables of a day in steps; those of -en17037 are of a year");
    if (o.months && (o.next || o.worst > 0)) base::fail("-months", "prints other lines than -next and -worst");
    if (o.months && (!o.en17037.empty() || !o.sun_steps.empty() || !o.overcast.empty() || o.leed))
        base::fail("-months", "counts no month for -en17037, -sunlight, -overcast and -leed");
    if (o.leed && (o.format || o.each)) base::fail("-leed", "is lines of text, without -format and -each");
    if (o.rooflight && o.en17037.empty()) base::fail("-rooflight", "is of -en17037");
    if (!o.plot.empty()) image::require_writable_ending(o.plot, {".svg", ".png"});
    if (!o.report.empty()) image::require_writable_ending(o.report, {".html"});
    check_report(o);
    std::vector<std::string> inputs = o.tables;
    for (const auto& more : {o.closed, o.direct, o.points, o.by, o.eyes, o.pictures, o.planes, o.openings})
        inputs.insert(inputs.end(), more.begin(), more.end());
    for (const std::string& file : {o.en17037, o.sun_steps, o.shades, o.overcast, o.plan, o.weather, o.view_out})
        if (!file.empty()) inputs.push_back(file);
    base::refuse_to_overwrite({o.plot, o.moves, o.report}, inputs);
    if (!o.warnings) base::set_warning_sink({});
    return std::nullopt;
}
