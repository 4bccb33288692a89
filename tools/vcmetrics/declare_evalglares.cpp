// SPDX-License-Identifier: BSD-3-Clause
// evalglare's options, with its letters, arguments and meanings: see declare.h.
#include "base/error.h"
#include "declare.h"
#include "display/file.h"

namespace {

using base::Arguments;
using base::OptionTable;

const base::Range pixels = base::within(-(1 << 20), 1 << 20);  // a column or row, possibly outside the picture

glare::Circle circle(Arguments& a) {
    glare::Circle c;
    c.x = int(a.integer(pixels));
    c.y = int(a.integer(pixels));
    c.opening = a.real(base::above(0));
    return c;
}

void read_fill(Arguments& a, glare::Settings& s) {
    s.external_ev = a.real();
    glare::Fill fill;
    fill.y_max = int(a.integer(pixels));
    fill.y_min = int(a.integer(pixels));
    s.fill = fill;
}

void read_constants(Arguments& a, glare::DgpConstants& k) {
    for (double* v : {&k.a1, &k.a2, &k.a3, &k.a4, &k.a5, &k.c1, &k.c2, &k.c3}) *v = a.real();
}

void read_patches(Arguments& a, Options& o) {
    glare::Patches patches;
    patches.angle_deg = a.real();
    patches.mode = int(a.integer(base::within(1, 3)));
    o.settings.patches = patches;
    if (patches.mode == 3) apply_compatibility(OutputMode::evalglare, o);
}

void read_low_light(Arguments& a, glare::Settings& s) {
    const std::string what = a.text();
    if (what == "l+") s.low_light = true;
    if (what == "l-" || what == "0") s.low_light = false;
}

void read_zones(Arguments& a, glare::Settings& s, bool two) {
    s.zones = glare::Zones{circle(a), {}};
    if (two) s.zones->outer_opening = a.real();
}

void declare_sources(OptionTable& t, Options& o) {
    glare::Settings& s = o.settings;
    t.group("evalglare's: glare sources", "evalglare");
    t.add("-b factor", "Threshold: factor of the task's or mean luminance; above 100, a luminance in cd/m2",
          s.threshold)
        .default_text("2000; 5 with a task");
    t.add("-t x y angle", "Task area: centre pixel, y from the bottom, and full opening angle in radians",
          [&](Arguments& a) { s.task = circle(a); });
    t.add("-T x y angle", "The task area of -t, painted in the check picture (-c)", [&](Arguments& a) {
        s.task = circle(a);
        o.evalglare.task_painted = true;
    });
    t.add("-r angle", "Search radius between pixels of one source, an opening angle", s.search_opening)
        .unit("radians")
        .above(0);
    t.add("-s", "Smooth sources: add dark pixels of whose surroundings a source covers a fifth", s.smooth);
    t.add("-y", "Extract peaks (the default)", base::set(s.peaks, true));
    t.add("-Y lum", "Extract peaks from this luminance on", [&](Arguments& a) {
         s.peaks = true;
         s.peak_limit = a.real();
     }).default_text("50000 cd/m2");
    t.add("-x", "Extract no peaks", base::set(s.peaks, false));
    t.add("-z angle mode", "Fixed patches in place of sources, in degrees; mode 1 prints metrics, 3 coefficients",
          [&](Arguments& a) { read_patches(a, o); });
    t.add("-l x y angle", "A zone: sources are split at its border, and statistics of it are printed",
          [&](Arguments& a) { read_zones(a, s, false); });
    t.add("-L x y angle1 angle2", "Two zones, one around the other", [&](Arguments& a) { read_zones(a, s, true); });
}

void declare_measures(OptionTable& t, glare::Settings& s) {
    using Model = glare::PositionModel;
    t.group("evalglare's: what is measured", "evalglare");
    t.add("-G type", "Cut the field of view after Ev is taken: 1 total, 2 both eyes, 3 both eyes, weighted by 1/P",
          [&](Arguments& a) { s.field_cut = int(a.integer(base::within(1, 3))); });
    t.add("-q mode", "Background luminance: 0 from Ev - Edir, 1 mean outside the sources, 2 Ev/pi", s.background)
        .within(0, 2);
    t.add("-C what", "Low light correction of DGP: l+ for on, l- or 0 for off", [&](Arguments& a) {
         read_low_light(a, s);
     }).default_text("off");
    t.add("-4", "No low light correction", base::set(s.low_light, false));
    t.add("-i Ev", "For DGP only: illuminance measured elsewhere", s.external_ev).unit("lux");
    t.add("-I Ev ymax ymin", "The same, and fill the rows from ymax up and from ymin down from the row beside them",
          [&](Arguments& a) { read_fill(a, s); });
    t.add("-k lum", "Leave out terms of LveilCIE up to this luminance", [&](Arguments& a) {
         s.formulas.veil_cut = a.real();
     }).unit("cd/m2");
    t.add("-P model", "Position index: 0 Guth, 1 KIM", [&](Arguments& a) {
         s.position = a.integer(base::within(0, 1)) ? Model::kim : Model::guth;
     }).default_text("0");
    t.add("-w a1 a2 a3 a4 a5 c1 c2 c3", "Constants of DGP", [&](Arguments& a) { read_constants(a, s.constants); });
    t.add("-A file", "Mask picture (pixels above 0.1 cd/m2): its statistics, PGSV",
          [&](Arguments& a) { s.mask_file = a.text(); });
    t.add("-B angle", "Statistics of a horizontal band, half height", s.band_rad).unit("radians");
    t.add("-f", "Measure a perspective picture even if its corners are black", s.force);
}

// Options for evalglare's lines only: each implies -like evalglare.
void declare_lines(OptionTable& t, Options& o) {
    const auto implies = [&](auto& variable, auto value) {
        return [&o, &variable, value](Arguments&) {
            apply_compatibility(OutputMode::evalglare, o);
            variable = value;
        };
    };
    t.group("evalglare's: its lines (each implies -like evalglare)", "evalglare");
    t.add("-d", "The detailed lines", implies(o.evalglare.detailed, true));
    t.add("-D", "The line with Ev and the largest luminance", implies(o.evalglare.dgp_and_ev, true));
    t.add("-V", "Print only Ev; the status is 1, as evalglare's", implies(o.evalglare.ev_only, true));
    t.add("-1", "The fast DGP, of -i Ev", implies(o.evalglare.fast, 1));
    t.add("-2 Edir", "The fast DGP and UGR", [&](Arguments& a) {
        apply_compatibility(OutputMode::evalglare, o);
        o.evalglare.fast = 2;
        o.evalglare.fast_direct = a.real();
    });
    t.add("-3", "The third fast mode: prints nothing", implies(o.evalglare.fast, 3));
}

void read_colour(Arguments& a, evalglare::Settings& s) {
    const base::Vec3 c = a.vec();
    const double sum = c.x + c.y + c.z;
    if (!(c.x >= 0 && c.y >= 0 && c.z >= 0 && sum > 0)) base::fail(a.name(), "a colour has no negative part and a sum");
    s.source_paint = evalglare::Paint{c.x / sum, c.y / sum, c.z / sum};
}

void declare_check_picture(OptionTable& t, Options& o) {
    t.group("evalglare's: its check picture", "evalglare");
    t.add("-c file", "Write a grey picture with the sources, task (-T) and zones in colours", [&](Arguments& a) {
        o.check_file = a.text();
        display::require_writable_ending(o.check_file);
    });
    t.add("-u r g b", "One colour for all sources in it, as shares of their luminance", [&](Arguments& a) {
         read_colour(a, o.evalglare);
     }).default_text("five colours in turn");
}

void declare_refused(OptionTable& t) {
    const char* const pictures =
        "evalglare writes a picture here; vcmetrics only measures (pcomb and pvalue change pictures)";
    t.group("evalglare's: not here", "evalglare");
    t.refuse("-a age", "Removed from evalglare: an error",
             "the age factor was removed from evalglare and is not supported here");
    for (const char* spelling : {"-m ...", "-M ...", "-N ...", "-O ..."})
        t.refuse(spelling, "Not here: rewrites the picture", pictures);
    t.refuse("-p ...", "Not here: writes the position index", pictures);
    t.refuse("-g type", "Not here: writes the field of view (-G measures it)", pictures);
    t.refuse("-Q ...", "Not here: pastes several pictures into one",
             "evalglare's several-pictures mode is not here; vcmetrics reads any number of pictures one after another");
}

}  // namespace

void declare_evalglares_options(OptionTable& t, Options& o) {
    declare_sources(t, o);
    declare_measures(t, o.settings);
    declare_lines(t, o);
    declare_check_picture(t, o);
    declare_refused(t);
}
