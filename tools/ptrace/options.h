// SPDX-License-Identifier: BSD-3-Clause
// ptrace's command line: rpict's view and rendering options, read in order, plus our own few words.
// To add an option: CONTRIBUTING.md, "Add an option".
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/processors.h"
#include "image/points.h"
#include "scene/object.h"
#include "scene/states.h"
#include "render/options.h"
#include "render/view_plan.h"
#include "render/action.h"
#include "skies.h"
#include "view/view.h"
#include "weather/rendered.h"

// A picture and its name; a single one has none.
struct NamedView {
    std::string name;
    render::RenderView render_view;
};

// -action, and how its pictures are called.
struct ActionRun {
    image::Action label;
    spectrum::Action action;
};

struct Options {
    render::RenderOptions render;
    view::View view;
    std::vector<std::string> views_files;   // -views: a picture of each view in them; "-": standard input (-S)
    int64_t first_view = 1;                 // -S: the number of the first one without a name
    std::vector<Sky> skies;                 // -sky, -wea: the scene with each of these in turn
    std::string weather, hours = "all";     // -wea, -hours
    HourOptions hour_options;               // -occupied, -wea-shift
    std::vector<std::string> state_words;   // -state
    bool honeybee_states = false;           // -honeybee-states
    std::vector<scene::State> states;       // of the scene, one at least
    std::string state;                      // the name of the one at hand
    bool last_state = true;                 // that it is
    bool second_sky = false;                // -second-sky
    bool hours_apart = false;               // -hours-apart: each rendered by itself
    std::string mean_sky;                   // that stands for those of all hours (render/hours.h)
    std::vector<std::string> action_words;  // -action
    std::string daylight = "D65";           // -daylight: of lights without a spectrum
    std::vector<std::string> lamp_words;    // -lamp
    int bands = 0;                          // -bands; 0: as the action has it
    flatten::LightSpectra lights;           // of -daylight and -lamp
    std::vector<ActionRun> actions;
    std::vector<std::string> after;         // -after
    weather::Rendered rendered;             // hours of its tables
    std::vector<std::string> points_files;  // -points: one picture of these points; "-": standard input
    std::optional<bool> sensors;            // -I: of -points; absent: not said
    std::vector<image::Grid> grids;         // of the points
    image::GridFiles grid_files;            // their files
    int nx = 512, ny = 512;
    double pixel_aspect = 1;            // -pa, 0 keeps both sides
    double exposure = 1;                // -rif: of the pictures written
    int64_t first = 0, last = endless;  // frames, both included
    std::string device = "auto";
    std::string rule_for;      // -M: the target of a rule of make; empty: none
    std::string rule_file;     // -MF: where it goes, before rendering; empty: stdout, and render nothing
    std::string command;       // the whole command line, for the headers of the frames
    std::string control;       // -control: a FIFO with commands; empty: none
    bool watch = false;        // -watch: begin anew when a file of the scene changes
    std::string output;        // -o pattern; empty: stdout
    bool one_picture = false;  // -picture: their sum instead of the frames
    bool moments = true;       // -moments
    struct Pixel {
        int x, y;
    };
    std::optional<Pixel> pixel;             // -pixel: explained instead of frames
    bool preview = false;                   // by -control: rough pictures
    int threads = int(base::processors());  // -n
    int report_s = 0;                       // -t: a line on stderr every so many seconds
    bool warnings = true;                   // -w
    scene::ReadOptions files;               // RAYPATH, -exec
    std::vector<std::string> scene_files;
    std::string focus_file;        // -focus: regions that get more samples; empty: none
    double focus_share = .125;     // their samples, over those of the picture
    std::vector<NamedView> views;  // what is rendered, one or several

    static constexpr int64_t frames_of_picture = 64;  // of -picture, where -frames is not given
    static constexpr int64_t frames_of_hours = 16;    // diffuse ones of hours that are rendered together, likewise
    static constexpr int64_t endless = 0xfffffffe;    // the samplers count frames in 32 bits
};

// May edits come?
inline bool is_live(const Options& opt) { return opt.watch || !opt.control.empty(); }

// Fills opt and checks it.  A status: the answer (-help, -version, -devices ...) was printed, main ends with it.
std::optional<int> parse_options(int argc, char** argv, Options& opt);

// Reads the files of -points: the one picture.
void read_points(Options& opt);

// Empty, or why its hours are rendered one by one.
std::string why_apart(const Options& opt);

// The file of frame k: the pattern's one %d (%4d, %04d) replaced, and %s by the name of the picture; a pattern without
// serves a single frame.
std::string output_name(const std::string& pattern, int64_t k, const std::string& label);
