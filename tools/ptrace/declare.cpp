// SPDX-License-Identifier: BSD-3-Clause
// ptrace's options, each declared once (base/options.h).  from_scene() marks what a rad input file may say: how light
// is followed and from where it is seen.  Programs, files to write, devices, frames and messages are the user's
// (docs/security.md).
#include "declare.h"

#include <fmt/core.h>

#include <filesystem>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/process.h"
#include "base/value.h"
#include "render/make_device.h"

namespace {

using base::Arguments;
using base::OptionTable;

void send_messages_to(const std::string& path) {
    if (!base::append_to(2, path)) base::fail_system(path, "cannot be written");
}

void read_frames(const std::string& text, Options& opt) {
    const size_t colon = text.find(':');
    if (colon == std::string::npos) {
        const long n = base::to_int(text, "-frames");
        if (n < 1) base::fail("-frames", "needs at least 1 frame, not " + text);
        opt.first = 0, opt.last = n - 1;
    } else {
        opt.first = base::to_int(text.substr(0, colon), "-frames");
        opt.last = base::to_int(text.substr(colon + 1), "-frames");
        if (opt.first < 0) base::fail("-frames", "frames count from 0, not from " + std::to_string(opt.first));
        if (opt.last < opt.first) base::fail("-frames", text + " contains no frames");
    }
    if (opt.last >= Options::endless)
        base::fail("-frames", fmt::format("frame numbers must be below {}", Options::endless));
}

void read_pixel(const std::string& text, Options& opt) {
    const size_t comma = text.find(',');
    if (comma == std::string::npos) base::fail("-pixel", "needs a pixel such as 120,88, not " + text);
    const auto number = [](const std::string& word) { return int(base::to_int(word, "-pixel")); };
    opt.pixel = {number(text.substr(0, comma)), number(text.substr(comma + 1))};
}

void read_rif(const std::string& path, const std::vector<std::string>& assignments, OptionTable& t, Options& opt,
              std::optional<scene::RadInput>& rad_input) {
    base::note_file_read(*opt.files.read, path);
    rad_input = scene::read_rad_input(path, assignments);
    t.read_scene_words(rad_input->options, path);
    opt.files.asked_by = path;
    opt.exposure = rad_input->exposure;
}

// Beside the folder of the programs, in a build as where they are installed.
std::string library() {
    const std::filesystem::path program = base::program_file();
    const std::filesystem::path folder = program.parent_path().parent_path() / "share/luxpipe/library";
    if (!std::filesystem::is_directory(folder)) base::fail_system(folder.generic_string(), "is not there");
    return folder.generic_string() + "\n";
}

std::string devices() {
    std::string text;
    for (const std::string& device : render::list_devices()) text += device + "\n";
    return text;
}

void declare_pictures(OptionTable& t, Options& opt) {
    t.group("Several pictures");
    t.add("-views file", "A picture for each view of this file; may be repeated", opt.views_files);
    t.add("-S n", "A picture for each view from the standard input, numbered from n", [&](Arguments& a) {
        opt.first_view = a.integer(base::within(0, 1e9));
        opt.views_files.emplace_back("-");
    });
    t.add("-points file", "A picture of points, x y z dx dy dz in each line of this file; may be repeated, - is stdin",
          opt.points_files);
    t.add("-I[+-]", "Irradiance at the points, with their directions as normals; else radiance along their rays",
          base::Action([&opt](Arguments& a) { opt.sensors = a.text() == "+"; },
                       [&opt] { return opt.sensors ? *opt.sensors ? "+" : "-" : ""; }))
        .default_text("on with -points");
    t.add("-sky file", "A picture with this file added to the scene; may be repeated",
          [&](Arguments& a) { opt.skies.push_back(sky_of_file(a.text())); });
    t.add("-wea file", "A picture for each hour of this weather file, EPW or WEA", opt.weather);
    t.add("-hours words", "Hours to render, such as 'Mo-Fr 8-18'", opt.hours);
    t.add("-hours-apart", "Render each hour by itself, with paths of its own", opt.hours_apart);
    t.add("-after file", "Go on: with the next frame of this sum (.exr), or with the hours that this table lacks",
          opt.after);
    t.add("-occupied f", "Value of a schedule (-hours @file) from which an hour counts", [&](Arguments& a) {
         opt.hour_options.used_from = a.real(base::within(0, 1e9));
     }).default_text("0.1; of Daysim's anything above 0");
    t.add("-wea-shift h", "Move the sun of -wea to where it stands h hours later", opt.hour_options.shift_h)
        .within(-12, 12);
    t.add("-state words", "Pictures of the scene in this state: a name, and the files that it changes; may be repeated",
          opt.state_words);
    t.add("-honeybee-states[+-]", "Pictures of a Honeybee folder in all states of its groups", opt.honeybee_states);
    t.add("-second-sky[+-]", "A scene may have a sun or a sky beside that of -wea or -sky", opt.second_sky);
}

void declare_actions(OptionTable& t, Options& opt) {
    t.group("Light by an action");
    t.add("-action word",
          "Pictures of light by an action in place of V: mel rh sc mc lc, V, or a file; may be repeated",
          opt.action_words);
    t.add("-bands n", "Bands of an action, three by three", opt.bands).within(0, 60).default_text("9; 12 for V");
    t.add("-daylight word",
          "Illuminant of lights without a spectrum, such as D65, 5500 (K), A, or a file; sky: by its clearness",
          opt.daylight);
    t.add("-lamp name=word", "Illuminant of the light with this name, such as lamp=F11; may be repeated",
          opt.lamp_words);
}

void declare_picture(OptionTable& t, Options& opt) {
    t.group("Picture");
    t.add("-x n", "Horizontal resolution", opt.nx).within(1, 32768).from_scene();
    t.add("-y n", "Vertical resolution", opt.ny).within(1, 32768).from_scene();
    t.add("-pa f", "Pixel aspect, height over width; 0 keeps both resolutions", opt.pixel_aspect)
        .at_least(0)
        .from_scene();
}

void declare_frames(OptionTable& t, Options& opt, std::optional<scene::RadInput>& rad_input,
                    const std::vector<std::string>& assignments) {
    t.group("Frames and devices");
    t.add("-frames N|A:B", "Frames 0 to N-1, or A to B, both included", [&](Arguments& a) {
         read_frames(a.text(), opt);
     }).default_text("endless");
    t.add("-picture", "One ordinary picture, the sum of the frames (64 without -frames), as rpict writes it",
          opt.one_picture);
    t.add("-pixel x,y", "Break down the light of one pixel, in place of frames; 0,0 is the lower left one",
          [&](Arguments& a) { read_pixel(a.text(), opt); });
    t.add("-seed n", "Seed of the random numbers", opt.render.seed).at_least(0);
    t.add("-focus file", "More samples for these regions: masks of vcregion(1), or a file of vcregion(5)",
          opt.focus_file);
    t.add("-focus-share f", "Extra samples for the regions of -focus, as a share of the picture's", opt.focus_share)
        .within(0, 100)
        .share();
    t.add("-moments[+-]", "Moments of the light inside each pixel, behind frame 0", opt.moments);
    t.add("-device name", "Device that renders: auto, cpu, opencl, opencl:N or opencl:NAME", opt.device);
    t.add("-n n", "Threads of the CPU devices", opt.threads)
        .within(1, 4096)
        .default_text("all that the process may use");
    t.add("-control fifo",
          "Obey the lines that arrive here: next, pause, go, view, set, size, scene, overlay, note, preview, what",
          opt.control);
    t.add("-watch", "Begin anew when a file of the scene changes", opt.watch);
    t.add("-o pattern", "Write frames to files such as f%04d.hdr", opt.output);
    t.add("-M target", "Print a rule of make: this target and all files that are read for it; render nothing",
          opt.rule_for);
    t.add("-MF file", "Write the rule of -M to this file, and render", opt.rule_file);
    t.add("-exec", "Let the scene run its !commands", opt.files.exec);
    t.add("-rif file", "Take scene, options and views from an input file of rad(1)",
          [&](Arguments& a) { read_rif(a.text(), assignments, t, opt, rad_input); });
}

void declare_messages(OptionTable& t, Options& opt) {
    t.group("Messages");
    t.add("-t s", "Report progress on the standard error every s seconds", opt.report_s)
        .at_least(0)
        .default_text("none")
        .passed_over_in_scene();
    t.add("-w[+-]", "Warnings", opt.warnings).passed_over_in_scene();
    t.add("-e file", "Append messages to a file instead of the standard error",
          [](Arguments& a) { send_messages_to(a.text()); });
    t.question("-devices", "List the devices", devices);
    t.question("-library", "Print the folder of the library: paints, glazings, fabrics and slats of blinds", library);
}

// Options of rpict that steer what a path tracer does not have: its cache, its thresholds, its pixel interpolation,
// its animations and its files.
void declare_rpicts(OptionTable& t) {
    using Scenes = OptionTable::Scenes;
    t.group("", "rpict");
    t.ignored("-aa -ar -ad -as -aw -af -ai -aI -ae -aE -am", 1, Scenes::yes);
    t.ignored("-ap", 1, Scenes::yes, 2);  // a file and up to two bandwidths
    t.ignored("-dt -dc -ps -pt -pm -cs", 1, Scenes::yes);
    t.ignored("-cw", 2, Scenes::yes);
    t.ignored("-pRGB", 0, Scenes::yes);
    t.ignored("-P -PP -r -ro", 1, Scenes::no);
    t.ignored("-z", 1, Scenes::no);
    for (const char* name : {"-pXYZ", "-pc"}) t.refuse(name, "", "frames are in RADIANCE's RGB");
}

}  // namespace

void declare_options(OptionTable& t, Options& opt, std::optional<scene::RadInput>& rad_input,
                     const std::vector<std::string>& assignments) {
    view::declare_options(t, opt.view);
    view::declare_file_option(t, [&](const view::View& v) { opt.view = v; });
    declare_pictures(t, opt);
    declare_actions(t, opt);
    declare_picture(t, opt);
    render::declare_options(t, opt.render);
    t.add("-f file", "A function file whose definitions all functions of the scene may use", opt.files.cal_files)
        .from_scene();
    declare_frames(t, opt, rad_input, assignments);
    declare_messages(t, opt);
    declare_rpicts(t);
    t.examples(R"(In the folder examples/scenes/office:
  ptrace -picture -x 256 -y 256 -vf view.vf materials.rad layout.rad sky_1400.rad > office.hdr
  ptrace -frames 16 -vf view.vf materials.rad layout.rad sky_1400.rad | ptaccum -o office.png
  ptrace -x 128 -y 128 -vf view.vf materials.rad layout.rad sky_1400.rad | ptaccum -every x2/4 |
      vcmetrics -metrics Ev,DGPf -ci 95 -until 'DGPf 0.01'
)");
    t.options_come_before("the scene files");
    t.footer("Options of rpict that are read past: ptrace -help rpict.  ");
}
