// SPDX-License-Identifier: BSD-3-Clause
// ptrace's command line: read, what -rif brings, and what does not go together.
#include "options.h"

#include <fmt/core.h>

#include <algorithm>
#include <set>

#include "after.h"
#include "base/error.h"
#include "base/file_status.h"
#include "base/model_folder.h"
#include "base/run.h"
#include "base/split.h"
#include "base/warnings.h"
#include "choose_actions.h"
#include "declare.h"
#include "image/header.h"
#include "image/stream.h"
#include "scene/rad_input.h"

namespace {

// View options after -rif override the view that is chosen by its name.
std::vector<std::string> view_words_after_rif(const base::OptionTable& table) {
    std::vector<std::string> words;
    bool after = false;
    for (const auto& [option, said] : table.parsed()) {
        after = after || option->name == "-rif";
        if (after && option->group() == "View") words.insert(words.end(), said.begin(), said.end());
    }
    return words;
}

void choose_view(const scene::RadInput& rad_input, const std::string& name, base::OptionTable& table, Options& opt) {
    opt.view = view::View();
    table.read_scene_words(scene::view_words(rad_input, name), rad_input.path);
    table.read_words(view_words_after_rif(table));
}

void add_view(const std::string& name, Options& opt) {
    render::RenderView v{opt.view, opt.nx, opt.ny};
    view::fit_size(v.view, opt.pixel_aspect, v.nx, v.ny);
    opt.views.push_back({name, v});
}

void add_points(Options& opt) {
    if (!opt.views_files.empty()) base::fail("-points", "is a picture of its own, beside which -views has no place");
    if (!opt.focus_file.empty()) base::fail("-focus", "points have no regions; their grids are some");
    if (std::count(opt.points_files.begin(), opt.points_files.end(), "-") > 1)
        base::fail("-points", "the standard input is read once");
    read_points(opt);
    opt.moments = false;
}

// The pictures: one, those of -views, or all of a rad input file where none of its views is named.
void choose_views(const std::optional<scene::RadInput>& rad_input, const std::string& view_name,
                  base::OptionTable& table, Options& opt) {
    const bool all = rad_input && view_name.empty() && rad_input->views.size() > 1;
    if (!opt.points_files.empty()) return add_points(opt);
    if (opt.sensors) base::fail("-I", "needs the points of -points; -i is the irradiance of what a view shows");
    if (rad_input && !all) choose_view(*rad_input, view_name, table, opt);
    if (!opt.views_files.empty()) {
        if (std::count(opt.views_files.begin(), opt.views_files.end(), "-") > 1)
            base::fail("-views", "the standard input is read once");
        const view::View start = opt.view;
        for (const std::string& file : opt.views_files) {
            if (file != "-") base::note_file_read(*opt.files.read, file);
            for (const view::NamedView& v : view::read_views(file, start)) {
                opt.view = v.view;
                add_view(v.name.empty() ? std::to_string(opt.first_view + int64_t(opt.views.size())) : v.name, opt);
            }
        }
    } else if (all) {
        for (size_t k = 0; k < rad_input->views.size(); ++k) {
            const std::string number = std::to_string(k + 1), name = rad_input->views[k].name;
            choose_view(*rad_input, name.empty() ? number : name, table, opt);
            add_view(name.empty() ? number : name, opt);
        }
    } else {
        add_view("", opt);
    }
}

void choose_hours(const base::OptionTable& table, Options& opt) {
    for (const char* name : {"-hours", "-occupied", "-wea-shift"})
        if (opt.weather.empty() && table.given(name)) base::fail(name, "needs a weather file: -wea");
    using scene::Skies;
    opt.files.skies = opt.second_sky ? Skies::any : opt.weather.empty() ? Skies::one : Skies::of_weather;
    if (opt.weather.empty()) return;
    if (!opt.skies.empty()) base::fail("-wea", "has its own skies; -sky is for those of files");
    base::note_file_read(*opt.files.read, opt.weather);
    for (const std::string& word : base::split_words(opt.hours))
        if (word[0] == '@') base::note_file_read(*opt.files.read, word.substr(1));  // a schedule
    HourSkies hours = skies_of_hours(opt.weather, opt.hours, opt.hour_options, opt.render.seed);
    if (hours.skies.empty()) base::fail("-hours", "this share holds no hour");
    opt.skies = std::move(hours.skies);
    opt.mean_sky = std::move(hours.mean_sky);
    base::say("ptrace: " + hours.note);
}

void choose_states(Options& opt) {
    if (opt.honeybee_states)
        for (const std::string& word : scene::honeybee_states(opt.scene_files)) opt.state_words.push_back(word);
    opt.states = scene::states_of(opt.state_words, opt.scene_files);
    if (opt.states.size() < 2) return;
    if (is_live(opt)) base::fail("-state", "edits are of one state: -watch and -control do not go with several");
    if (opt.states[0].name.find('/') != std::string::npos)
        base::say(fmt::format("ptrace: {} states: those of the groups combined", opt.states.size()));
}

// Names are those of files and of rows in tables.
void check_names(const Options& opt) {
    std::set<std::string> views, skies;
    for (const NamedView& s : opt.views) {
        if (!s.name.empty()) image::plain_name(s.name, "the view");
        if (!views.insert(s.name).second) base::fail("", "two views are called \"" + s.name + "\"");
    }
    for (const scene::State& s : opt.states)
        if (!s.name.empty()) image::state_name(s.name, "-state");
    for (const Sky& sky : opt.skies) {
        image::plain_name(sky.name, sky.file);
        if (!skies.insert(sky.name).second) base::fail(sky.file, "two skies are called \"" + sky.name + "\"");
    }
}

void check_output(const Options& opt) {
    if (opt.last == Options::endless) base::fail("-frames", "say how many frames to write to files");
    image::Header first;
    first.view_name = opt.views[0].name, first.state = opt.states[0].name;
    if (!opt.skies.empty()) first.sky_name = opt.skies[0].name;
    const std::string label = image::label(first);
    if (opt.one_picture) {
        if (opt.output.find("%d") != std::string::npos)
            base::fail("-o", "\"" + opt.output + "\": -picture writes no numbered frames, so %d has no meaning");
    } else if (opt.last > opt.first && output_name(opt.output, 0, label) == output_name(opt.output, 1, label))
        base::fail("-o", "\"" + opt.output + "\" needs a %d for the number of the frame");
    const bool several = !label.empty();
    if (several && opt.output.find("%s") == std::string::npos)
        base::fail("-o", "\"" + opt.output + "\" needs a %s for the names of several pictures");
    image::require_writable_ending(output_name(opt.output, opt.first, label));
}

void check_pixel(const Options& opt) {
    const render::RenderView& v = opt.views[0].render_view;
    if (opt.views.size() > 1 || opt.skies.size() > 1 || opt.states.size() > 1 || opt.actions.size() > 1)
        base::fail("-pixel", "is of one picture, but there are several");
    if (opt.pixel->x < 0 || opt.pixel->x >= v.nx || opt.pixel->y < 0 || opt.pixel->y >= v.ny)
        base::fail("-pixel",
                   fmt::format("{},{} is outside of a picture of {} x {}", opt.pixel->x, opt.pixel->y, v.nx, v.ny));
    if (!opt.output.empty() || opt.one_picture || is_live(opt))
        base::fail("-pixel", "writes no picture: -o, -picture, -watch and -control do not go with it");
}

void check(const Options& opt) {
    if (opt.scene_files.empty()) base::fail("", "no scene file; ptrace -help lists the options");
    for (const NamedView& s : opt.views) view::validate(s.render_view.view);
    check_names(opt);
    const auto reads_stdin = std::count(opt.scene_files.begin(), opt.scene_files.end(), "-");
    if (reads_stdin && std::count(opt.views_files.begin(), opt.views_files.end(), "-"))
        base::fail("-", "the standard input has the views, not a scene");
    if (reads_stdin && std::count(opt.points_files.begin(), opt.points_files.end(), "-"))
        base::fail("-", "the standard input has the points, not a scene");
    if (reads_stdin && opt.states.size() > 1) base::fail("-", "is read once, but the scene is read for each -state");
    if (!opt.rule_file.empty() && opt.rule_for.empty()) base::fail("-MF", "needs -M for the rule's target");
    const double* av = opt.render.av;
    if (opt.render.ab == render::no_limit && (av[0] > 0 || av[1] > 0 || av[2] > 0))
        base::warn("-av", "ignored, except in mist: without -ab n there is no last bounce");
    if (!opt.rule_for.empty() && opt.rule_file.empty()) return;
    for (const NamedView& s : opt.views) render::require_memory(s.render_view);
    if (opt.pixel) return check_pixel(opt);
    const bool several = opt.views.size() > 1 || opt.skies.size() > 1 || opt.states.size() > 1 || !opt.actions.empty();
    if (several && opt.last == Options::endless && (opt.control.empty() || !opt.actions.empty()))
        base::fail("-frames", "say how many frames each picture gets");
    if (opt.watch && opt.first != 0) base::fail("-watch", "needs frame 0: a picture begins anew with it");
    if (opt.watch && reads_stdin) base::fail("-watch", "the standard input cannot be read again");
    if (opt.watch && !opt.output.empty())
        base::fail("-watch", "works with a stream of frames, not with the files of -o");
    if (!opt.output.empty()) return check_output(opt);
    const base::FileKind out = base::status_of(1).kind;
    if (out == base::FileKind::none) base::fail_system("stdout", "cannot be written");
    if (base::stdout_is_terminal()) base::fail("stdout", "pictures are binary; pipe them or name files with -o");
    const bool reader = out == base::FileKind::pipe || out == base::FileKind::socket;
    if (!reader && opt.last == Options::endless)
        base::fail("-frames", "say how many frames; stdout has no reader that could end the stream");
}

// "QUALITY=Low" after a rad input file stands for a line at its end, as on rad's own command line.  The file
// is read where -rif stands among the options; so the command line is read again once such words have been seen.
std::optional<int> parse(int argc, char** argv, const std::vector<std::string>& assignments, Options& opt) {
    opt.files.raypath = base::raypath_from_environment();
    opt.files.work = base::work_budget_from_environment();
    std::optional<scene::RadInput> rad_input;
    base::OptionTable table("ptrace", LUXPIPE_VERSION, "[options] scene.rad ... (\"-\": stdin)");
    declare_options(table, opt, rad_input, assignments);
    auto operands = table.parse(argc, argv);
    if (!operands) return 0;

    if (rad_input) {
        const auto split = std::stable_partition(operands->begin(), operands->end(), [](const std::string& word) {
            return word.find('=') == std::string::npos;
        });
        const std::vector<std::string> said(split, operands->end());
        if (assignments != said) {
            opt = Options();
            return parse(argc, argv, said, opt);
        }
        operands->erase(split, operands->end());
        if (operands->size() > 1) base::fail("-rif", "one view name at most, not \"" + (*operands)[1] + "\" too");
        opt.scene_files = rad_input->scene_files;
    } else {
        opt.scene_files = *operands;
    }
    opt.scene_files = base::open_folders(opt.scene_files, opt.files);
    choose_states(opt);
    choose_actions(opt);
    choose_views(rad_input, rad_input && !operands->empty() ? operands->front() : "", table, opt);
    base::note_files(*opt.files.read, table.files_read());
    opt.command = table.command();
    opt.render.names = opt.pixel || !opt.control.empty();
    if (opt.one_picture) {
        if (opt.watch || !opt.control.empty())
            base::fail("-picture", "is one picture: -watch and -control steer a stream");
        if (opt.first != 0) base::fail("-picture", "needs frame 0: without it the sum is not a picture");
        if (opt.last == Options::endless) opt.last = Options::frames_of_picture - 1;
        opt.moments = false;
    }
    if (opt.pixel && opt.last == Options::endless) opt.last = Options::frames_of_picture - 1;
    base::use_processors(unsigned(opt.threads));
    if (!opt.warnings) base::set_warning_sink({});
    choose_hours(table, opt);
    if (opt.last == Options::endless && why_apart(opt).empty()) opt.last = opt.first + Options::frames_of_hours;
    go_on_after(opt, table.given("-seed"));
    std::string ignored, spectral;
    for (const std::string& name : table.ignored_ones())
        if (name == "-z") base::warn("-z", "ignored: no depth file is written");
        else (name == "-cs" || name == "-cw" ? spectral : ignored) += " " + name;
    if (!spectral.empty()) base::warn(spectral.substr(1), "ignored: spectra are folded to RGB");
    if (!ignored.empty()) base::warn("", "a path tracer does not need" + ignored);
    check(opt);
    return std::nullopt;
}

}  // namespace

std::string why_apart(const Options& opt) {
    if (opt.hours_apart) return "-hours-apart";
    if (opt.weather.empty()) return "there are no hours of a weather file";
    if (is_live(opt)) return "edits may come";
    if (opt.pixel) return "-pixel";
    if (!opt.focus_file.empty()) return "-focus";
    return "";
}

void read_points(Options& opt) {
    const image::GridFiles before = std::move(opt.grid_files);
    image::GridFiles& files = opt.grid_files = {};
    for (const image::PointFile& file : image::point_files(opt.points_files, opt.files.read.get())) {
        const auto known = std::find_if(before.begin(), before.end(), [&](const image::GridFile& f) {
            return file.path == "-" && f.path == "stdin";  // which is read once
        });
        files.push_back(known == before.end() ? image::read_points(file, opt.files.opener("")) : *known);
    }
    opt.grids = image::grids_of(files, opt.sensors.value_or(true));
    auto list = std::make_shared<render::PointList>();
    list->sensors = opt.sensors.value_or(true);
    for (const image::GridFile& file : files)
        list->points.insert(list->points.end(), file.points.begin(), file.points.end());
    for (const image::Grid& grid : opt.grids) list->hash += image::to_text(grid) + " ";
    render::RenderView v{opt.view, 0, 0};
    image::size_for(list->points.size(), v.nx, v.ny);
    v.points = std::move(list);
    opt.views = {{"", v}};
}

std::string output_name(const std::string& pattern, int64_t k, const std::string& label) {
    std::string name = pattern;
    if (const size_t at = name.find("%s"); at != std::string::npos) {
        if (label.empty()) base::fail("-o", "\"" + pattern + "\": a single picture has no name for %s");
        name.replace(at, 2, label);
    }
    const size_t at = name.find('%');
    if (at == std::string::npos) return name;
    size_t end = at + 1;
    while (end < name.size() && name[end] >= '0' && name[end] <= '9') ++end;
    const std::string width = name.substr(at + 1, end - at - 1);
    if (end == name.size() || name[end] != 'd' || width.size() > 2 || name.find('%', end) != std::string::npos)
        base::fail("-o", "\"" + pattern + "\" must hold one %d, such as %04d");
    const std::string number = std::to_string(k);
    const size_t wide = width.empty() ? 0 : std::stoul(width);
    const std::string pad(wide > number.size() ? wide - number.size() : 0, width[0] == '0' ? '0' : ' ');
    return name.substr(0, at) + pad + number + name.substr(end + 1);
}

std::optional<int> parse_options(int argc, char** argv, Options& opt) { return parse(argc, argv, {}, opt); }
