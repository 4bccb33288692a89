// SPDX-License-Identifier: BSD-3-Clause
// ptrace - renders a RADIANCE scene by path tracing, frame after frame, each an ordinary picture on stdout.
// Frame 0 holds the direct and specular paths, frames 1, 2, ... one diffuse path sample a pixel each, more where it
// is noisy (paper Eq. 7); -picture writes their sum instead.
// The rendering lives in lib/render; this file only connects.  See man/ptrace.1.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "base/error.h"
#include "base/failed_before.h"
#include "base/files_read.h"
#include "base/progress.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "base/split.h"
#include "base/value.h"
#include "image/header.h"
#include "image/stream.h"
#include "edits.h"
#include "frames.h"
#include "hours.h"
#include "options.h"
#include "pixel.h"
#include "region/open.h"
#include "scene/object.h"
#include "render/control.h"
#include "render/hours.h"
#include "render/session.h"

namespace {

// A driver of OpenCL that sees the kernels for the first time compiles them, which takes it some ten seconds; for a GPU
// they are compiled when the scene is known.
std::unique_ptr<render::Renderer> start(const std::string& device) {
    base::Progress progress("ptrace");
    if (device.rfind("opencl", 0) == 0) progress.show("starts " + device + "; its kernels are compiled the first time");
    return std::make_unique<render::Renderer>(device);
}

size_t pictures(const Options& opt) {
    const auto lit = std::count_if(opt.skies.begin(), opt.skies.end(), [](const Sky& s) { return !s.is_black(); });
    return opt.views.size() * (opt.skies.empty() ? 1 : size_t(lit));
}

// State of a run, from one edit to the next.
struct Run {
    explicit Run(Options options) : opt(std::move(options)), report(opt.report_s, pictures(opt)) {}

    Options opt;
    render::Control control{opt.control, opt.watch};
    std::optional<render::Session> session;
    Report report;
    int64_t edits = 0;
    std::string edited = "start";
    std::string changed;  // by edits whose pictures were previews
    std::string note;     // words of "note" for the next full picture of an edit
    std::string failure;  // of the files as they are now; empty: they are what is rendered
};

// Setup of the session for picture i.
render::Setup setup_of(const Options& opt, size_t i, base::Progress& progress) {
    render::Setup setup{opt.views[i].render_view, opt.render, opt.files};
    setup.options.tell_tree = [&](double share) {
        if (progress.due()) progress.show(fmt::format("builds the tree of all surfaces, {:.0f} %", 100 * share));
    };
    return opt.preview ? render::preview_of(setup) : setup;
}

void write_rule(const Options& opt) {
    const std::vector<std::string> files = base::paths_of(*opt.files.read);
    const std::string rule = base::make_rule(opt.rule_for, files);
    base::refuse_to_overwrite({opt.rule_file}, files);
    if (opt.rule_file.empty()) base::write_stdout(rule.data(), rule.size());
    else image::write_bytes(opt.rule_file, rule);
}

// A file of regions is drawn for each view; masks are of one size.
void choose_focus(Options& opt) {
    if (opt.focus_file.empty()) return;
    image::DrawRegions draw;
    image::MaskSet masks = region::open(opt.focus_file, draw, region::Check::empty, false, opt.files.read.get());
    for (auto& [name, v] : opt.views) {
        if (draw) masks = draw(v.view, v.nx, v.ny);
        v.focus = render::focus_on(masks, v.nx, v.ny, opt.focus_share, opt.focus_file);
        if (v.focus.empty())
            base::warn(opt.focus_file,
                       "its regions are so large, or -focus-share so small, that none of their pixels gets a "
                       "second sample");
    }
}

// Failures are reported, and all goes on as before.  Returns the line of the failure, or nothing.
template <class F>
std::string carry_out(F&& work) {
    try {
        work();
        return "";
    } catch (const base::Error& e) {
        base::say("ptrace: " + e.text);
        return e.text;
    }
}

// The words of edits that are carried out together.
struct Words {
    std::string last, changed;  // of the last edit; of the last that neither asks for a preview nor ends one
    void add(const std::string& word) {
        last = word;
        if (word != "go" && word != "preview") changed = word;
    }
};

// Carries out what waits.  Where the files cannot be rendered what else was asked is carried out with those before,
// and the failure is said again with each such picture.  True: the picture begins anew.
bool apply_edits(Run& run, size_t i) {
    Options next = run.opt;
    Words words, others;
    bool read = false, begins = false;
    for (const render::Command& c : run.control.take_edits())
        carry_out([&] {
            if (c.word == "note") return void(run.note = c.rest);
            edit(c, i, next);
            words.add(c.word);
            if (reads_files(c)) read = true;
            else others.add(c.word);
        });
    if (words.last.empty()) return false;
    base::Progress progress("ptrace");
    if (read) next.files.read = std::make_shared<base::FilesRead>();
    const auto change = [&](bool files) {
        choose_focus(next);
        render::Setup setup = setup_of(next, i, progress);
        setup.options.tell_limit = next.render.ab != run.opt.render.ab;
        render::Session::ReadView read_view;
        if (!next.points_files.empty())
            read_view = [&](render::RenderView& view) {
                read_points(next);
                view = next.views[i].render_view;
                render::require_memory(view);
            };
        begins = run.session->edit(setup, files, read_view);
        run.opt = next;
    };
    std::string failure = carry_out([&] { change(read); });
    if (read) run.failure = failure;
    if (read && !failure.empty()) {
        base::note_files(*next.files.read, base::noted_now(*run.opt.files.read));
        run.opt.files.read = next.files.read;
    }
    run.control.watch(*run.opt.files.read);
    if (!failure.empty() && read && !others.last.empty()) {
        words = others;
        run.note.clear();  // it was for the files
        failure = carry_out([&] { change(false); });
    }
    if (failure.empty() && !words.changed.empty()) run.changed = words.changed;
    run.control.set_preview(run.opt.preview);
    if (!begins) {  // frames go on where they were
        if (!run.opt.preview) run.note.clear();
        return false;
    }
    run.edits++;
    run.edited = run.opt.preview ? "preview" : words.last;
    if (words.last == "go") run.edited = run.changed.empty() ? "view" : run.changed;
    if (run.opt.preview) return true;
    if (!read && !run.failure.empty()) base::say("ptrace: " + run.failure);
    if (!run.note.empty()) run.edited += " " + run.note;
    run.changed.clear();
    run.note.clear();
    return true;
}

// "what x y": one line, with the words of the question, the number of the edit and what is there (render/seen.h).
void answer_what(const Run& run, const std::string& rest) {
    carry_out([&] {
        const std::vector<std::string> words = base::split_words(rest);
        const std::string place = run.opt.control;
        if (words.size() != 2) base::fail(place, "what: needs two fractions of the picture");
        const double x = base::to_real(words[0], place), y = base::to_real(words[1], place);
        const std::string seen = run.session->renderer().seen(run.session->scene(), x, y);
        base::say("ptrace: what " + words[0] + " " + words[1] + "\t" + std::to_string(run.edits) + "\t" + seen);
    });
}

// One view under one sky, again after each edit.  last: of the run, which with -watch waits for edits then.
void render_view(Run& run, const Sky& sky, size_t i, bool last) {
    for (int64_t from = run.opt.first; !base::shutdown_requested();) {
        Options opt = run.opt;
        if (opt.preview) opt.moments = false;
        image::Picture picture = start_picture(opt, sky, i, &*run.session);
        if (is_live(opt)) picture.header.edit = run.edits, picture.header.edited = run.edited;
        const std::string label = image::label(picture.header);
        from = render_frames(opt, ends_of(opt, run.control, label), from, picture, run.session->renderer(), run.control,
                             run.report);
        if (opt.preview || (last && opt.watch)) run.control.wait_for_edit(label, opt.preview);
        if (!run.control.edited() || base::shutdown_requested()) return run.report.end();
        if (apply_edits(run, i)) from = run.opt.first;
    }
}

void render_dark(const Run& run, const Sky& sky) {
    base::finish_on_signal();
    for (size_t i = 0; i < run.opt.views.size() && !base::shutdown_requested(); ++i) {
        image::Picture picture = start_picture(run.opt, sky, i, nullptr);
        write_dark(run.opt, picture);
    }
}

// The hours of -wea together.  Returns false if they are to be rendered one by one.
bool render_together(Run& run) {
    const Options& opt = run.opt;
    if (!why_apart(opt).empty()) return false;
    if (std::none_of(opt.skies.begin(), opt.skies.end(), [](const Sky& sky) { return sky.light.has_value(); }))
        return false;
    base::Progress progress("ptrace");
    render::Setup setup = setup_of(opt, 0, progress);
    setup.options.tell_limit = true;
    run.session.emplace(start(opt.device), scene::read_scene(opt.scene_files, opt.files), opt.scene_files);
    run.session->load(opt.mean_sky, setup, render::Session::Next::views);
    if (const std::string why = render::why_apart(run.session->renderer().plan()); !why.empty()) {
        base::say("ptrace: each hour is rendered by itself: " + why);
        run.session.reset();
        return false;
    }
    if (!opt.rule_for.empty()) write_rule(opt);
    base::finish_on_signal();
    for (size_t i = 0; i < opt.views.size() && !base::shutdown_requested(); ++i) {
        if (i > 0) run.session->select(setup_of(opt, i, progress));
        progress.clear();
        render_hours(opt, i, *run.session, run.report);
    }
    return true;
}

int render_all(Options options) {
    Run run(std::move(options));
    choose_focus(run.opt);
    const Options& opt = run.opt;
    const bool only_rule = !opt.rule_for.empty() && opt.rule_file.empty();
    if (!only_rule && render_together(run)) return 0;
    const std::vector<Sky> skies = opt.skies.empty() ? std::vector<Sky>(1) : opt.skies;
    scene::Scene without_sky = scene::read_scene(opt.scene_files, opt.files);
    for (const Sky& sky : skies) {
        const bool last = &sky == &skies.back();
        if (base::shutdown_requested()) break;
        if (sky.seed) run.opt.render.seed = *sky.seed;
        if (sky.is_black() && !only_rule) {
            if (!opt.rule_for.empty() && last) write_rule(opt);
            render_dark(run, sky);
            continue;
        }
        base::Progress progress("ptrace");
        render::Setup setup = setup_of(opt, 0, progress);
        const bool is_first = !run.session;
        setup.options.tell_limit = is_first;
        // Files that a scene names are read when it is loaded; so the rule of -M needs a device, too.
        if (is_first) {
            run.session.emplace(start(only_rule ? "cpu" : opt.device), std::move(without_sky), opt.scene_files);
            if (is_live(opt)) run.session->renderer().heed(&run.control.wish());
            run.control.answer_with([&run](const std::string& words) { answer_what(run, words); });
        }
        using Next = render::Session::Next;
        const bool more_views = opt.views.size() > 1 || opt.pixel;
        run.session->load(sky.file, setup,
                          is_live(opt) || !last ? Next::skies_or_edits
                          : more_views          ? Next::views
                                                : Next::nothing);
        if (!opt.rule_for.empty() && last) write_rule(opt);
        if (only_rule) continue;
        run.control.watch(*opt.files.read);
        if (is_first && !run.session->may_have_light())
            base::warn("scene", "none of its materials gives light: is the sky missing?");
        if (opt.pixel) return write_pixel(opt, *run.session), 0;
        if (opt.output.empty() && !opt.one_picture && base::stdout_is_file() && &sky == &skies.front())
            base::warn("stdout",
                       "writing frames to a file, which only luxpipe can read; \"| ptaccum -last >\" makes a picture");
        base::finish_on_signal();
        for (size_t i = 0; i < opt.views.size() && !base::shutdown_requested(); ++i) {
            if (i > 0) run.session->select(setup_of(opt, i, progress));
            render_view(run, sky, i, last && i + 1 == opt.views.size());
        }
    }
    return 0;
}

int run(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    return render_all(std::move(opt));
}

}  // namespace

int main(int argc, char** argv) {
    base::mark_failure();
    return base::run("ptrace", [&] { return run(argc, argv); });
}
