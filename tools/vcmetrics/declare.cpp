// SPDX-License-Identifier: BSD-3-Clause
// Our own options: see declare.h.
#include "declare.h"

#include <algorithm>

#include "base/error.h"
#include "base/split.h"
#include "glare/columns.h"

namespace {

using base::Arguments;
using base::OptionTable;

void define_dgp(Arguments& a, glare::Settings& s) {
    switch (a.one_of({"evalglare", "paper", "pixel"})) {
    case 0: s.dgp_form = glare::DgpForm::merged, s.constants = {}; break;
    case 1: s.constants = glare::paper_dgp; break;
    default: s.dgp_form = glare::DgpForm::pixel;
    }
}

std::string without_blanks(std::string list) {
    list.erase(std::remove(list.begin(), list.end(), ' '), list.end());
    return list;
}

void declare_output(OptionTable& t, Options& o) {
    using Format = report::TableFormat;
    t.group("What is printed");
    t.add("-metrics list", "The columns, comma separated: " + glare::column_names(), [&](Arguments& a) {
        std::string list = a.text();  // 'Ev, DGP' and 'Ev DGP' are Ev,DGP
        std::replace(list.begin(), list.end(), ' ', ',');
        o.metrics = base::split_list(list, ',');
    });
    t.add("-each", "A row for each point of a picture of points, in place of numbers of its grids", o.each);
    t.add("-last", "Only the row of the last sum of each picture", o.last);
    t.add("-points file", "The points of -each and -over: the files that ptrace had, in their order", o.points_files);
    t.add("-regions file", "Named regions: masks of vcregion(1), or a file of vcregion(5)", o.regions_file);
    t.add("-cr pair", "Contrast ratio of two regions, low/high or name=low/high; may be repeated", [&](Arguments& a) {
        for (const std::string& pair : base::split_list(without_blanks(a.text()), ','))
            o.contrast_pairs.push_back(pair);
    });
    t.add("-sources", "Print a line for each glare source instead of the metrics", o.list_sources);
    t.add("-outlines", "With -sources and -format jsonl: the outline of each source as well", o.outlines);
    t.add("-spectrum light",
          "What a light is to the actions of CIE S 026, in place of pictures: its file, or F11, LED-B3, 5500 ...; may "
          "be repeated",
          [&](Arguments& a) { o.spectra.push_back(a.text()); });
    t.add("-over file", "Draw the picture with sources, regions and metrics (.png), or the map of points (.svg, .png)",
          [&](Arguments& a) { o.over_file = a.text(); });
    t.add("-report file", "Write a report of the last picture, for people (.html)", o.report_file);
    t.add("-scene file", "Scene of the report, which then says what is seen at glare sources; may be repeated",
          [&](Arguments& a) { o.scene.push_back(a.text()); });
    t.add("-about words", "A line of the report, such as 'Project: town hall'; may be repeated", [&](Arguments& a) {
        const std::string words = a.text();
        const size_t colon = words.find(':');
        if (colon == std::string::npos) base::fail("-about", "\"" + words + "\" is not like 'Project: town hall'");
        o.about.emplace_back(words.substr(0, colon), words.substr(std::min(words.size(), colon + 2)));
    });
    t.add("-criterion rule", "A rule that the report judges, such as 'EN 17037 medium: DGPf <= 0.40'; may be repeated",
          [&](Arguments& a) { o.criteria.push_back(report::parse_criterion(a.text(), "-criterion")); });
    t.add("-variant name picture file", "Another picture of the report, and a file of lines about it; may be repeated",
          [&](Arguments& a) {
              const std::string name = a.text(), picture = a.text();
              o.variants.push_back({name, picture, a.text()});
          });
    t.add("-day file", "Lines of the report about the hours of a day", o.day);
    t.add("-overlay file text", "Read the second file in place of the first one, a file of the scene",
          [&](Arguments& a) {
              const std::string file = a.text();
              o.overlays.emplace_back(file, a.text());
          });
    t.add("-plan map numbers", "Maps of the report (-over map.svg of points), with the last line of their table",
          [&](Arguments& a) { o.plan_map = a.text(), o.plan_numbers = a.text(); });
    t.add("-numbers file", "Numbers of the report: the last line of this table of vcmetrics", o.numbers_file);
    t.add("-ci percent",
          "NAME.lo and NAME.hi after each column: the interval of the converged value, of this certainty",
          [&](Arguments& a) { o.ci = a.real(base::within(50, 99.99)) / 100; });
    t.add("-halves", "Half-samples in the column errors, for vcyear; by itself with -last or -each of skies and hours",
          o.halves);
    t.add("-against edit",
          "NAME.d, NAME.d.lo and NAME.d.hi: the difference from the previous or the first edit, or one that a file "
          "names",
          o.against)
        .default_text("none");
    t.add("-format name", "Form of the table: tsv, csv or jsonl",
          base::one_of(o.format, {{"tsv", Format::tsv}, {"csv", Format::csv}, {"jsonl", Format::jsonl}}));
}

void declare_comparison(OptionTable& t, Options& o) {
    t.group("When to stop, and comparing");
    t.add("-until rule", "Stop when the numbers are this certain, for instance 'DGP 0.01, Ev 1%, class'", o.until);
    t.add("-go-on", "A column, settled, says that the rule holds, and the run goes on", o.go_on);
    t.add("-max-frames n", "Stop at this number of frames, frame 0 among them, as ptrace -frames",
          [&](Arguments& a) { o.max_frames = a.integer(base::within(1, 1e15)); });
    t.add("-max-seconds s", "Stop after this many seconds", o.max_seconds).above(0);
    t.add("-control fifo", "End each picture of the stream by itself: \"next\" to this FIFO of ptrace", o.control);
    t.add("-difference",
          "Print the difference of each metric between two inputs: pictures, streams, recorded tables or evalglare's "
          "lines",
          o.difference);
    t.add("-tolerance rules", "Must differences be within 'DGP 0.01, Ev 1%, all 2%', a file of such lines, or default",
          [&](Arguments& a) { o.tolerances = a.text(); })
        .default_text("none");
    t.group("");
    t.add("-compare", "", [&](Arguments&) {
        base::warn("-compare", "is called -difference -tolerance default, and goes with the next version");
        o.difference = true;
        if (!o.tolerances) o.tolerances = "default";
    });
}

void declare_definitions(OptionTable& t, Options& o) {
    using Area = glare::RammgArea;
    t.group("Definitions");
    t.add("-task name", "Take the threshold from this region: 5 times its mean luminance", o.settings.task_region);
    t.add("-like program", "Print and measure as evalglare or accelerad does; rtrace: its lines, of points",
          [&](Arguments& a) {
              const size_t program = a.one_of({"evalglare", "accelerad", "rtrace"});
              if (program == 2) o.like_rtrace = true;
              else apply_compatibility(program ? OutputMode::accelerad : OutputMode::evalglare, o);
          });
    t.add("-dgp form", "DGP as evalglare; paper: its constants 0.16 and 0.0918; pixel: every bright pixel is a source",
          [&](Arguments& a) { define_dgp(a, o.settings); })
        .default_text("evalglare");
    t.add(
        "-rammg area",
        "RAMMG over view; rect: black corners too; interior: pixels with eight neighbours; prototype: that without 1/8",
        base::one_of(o.settings.rammg_area, {{"view", Area::view},
                                             {"rect", Area::rectangle},
                                             {"interior", Area::interior},
                                             {"prototype", Area::prototype_scale}}));
}

}  // namespace

void apply_compatibility(OutputMode program, Options& o) {
    o.mode = program;
    if (program == OutputMode::evalglare) o.evalglare_bug_compatible = true;
    if (program != OutputMode::accelerad) return;

    // AcceleradRT: every bright pixel, older position index, always corrected
    o.format = report::TableFormat::csv;
    o.settings.dgp_form = glare::DgpForm::pixel;
    o.settings.position = glare::PositionModel::accelerad;
    o.settings.low_light = true;
    o.settings.rammg_area = glare::RammgArea::prototype_scale;
}

void declare_options(OptionTable& t, Options& o, view::View& view) {
    declare_output(t, o);
    declare_comparison(t, o);
    declare_definitions(t, o);
    view::declare_options(t, view, "the picture's");
    view::declare_file_option(t, [&](const view::View& v) { o.view = v; });
    declare_evalglares_options(t, o);

    t.group("General");
    t.add("-W[+-]", "Warnings", o.warnings);
    t.question("-v", "Print the version as well", [&t] { return t.version(); });
    t.examples(R"(In the folder examples/scenes/office:
  ptrace -x 128 -y 128 -vf view.vf materials.rad layout.rad sky_1400.rad |
      ptaccum -every x2/4 -o office.exr -o - |
      vcmetrics -metrics Ev,DGPf,classf -ci 95 -until 'DGPf 0.01'
  vcmetrics -sources office.exr
  vcmetrics -report office.html office.exr
)");
    t.footer("Options of one letter are evalglare's: vcmetrics -help evalglare.  ");
}
