// SPDX-License-Identifier: BSD-3-Clause
// ptrace - renders a RADIANCE scene by path tracing, frame after frame, each an ordinary picture on stdout.
// Frame 0 holds the direct and specular paths, frames 1, 2, ... one diffuse path sample a pixel each, more where it
// is noisy (paper Eq. 7); -picture writes their sum instead.
// The rendering lives in lib/render; this file only connects.  See man/ptrace.1.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "actions.h"
#include "after.h"
#include "base/error.h"
#include "base/failed_before.h"
#include "base/files_read.h"
#include "base/memory.h"
#include "base/progress.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "image/header.h"
#include "image/stream.h"
#include "frames.h"
#include "hours.h"
#include "options.h"
#include "pixel.h"
#include "session.h"
#include "render/hours.h"
#include "render/make_device.h"

namespace {

// A driver of OpenCL that sees the kernels for the first time compiles them, which takes it some ten seconds; for a GPU
// they are compiled when the scene is known.
std::unique_ptr<device::Device> start(const std::string& device) {
    base::Progress progress("ptrace");
    if (device.rfind("opencl", 0) == 0) progress.show("starts " + device + "; its kernels are compiled the first time");
    return render::make_device(device);
}

void write_rule(const Options& opt) {
    if (!opt.last_state) return;
    const std::vector<std::string> files = base::paths_of(*opt.files.read);
    const std::string rule = base::make_rule(opt.rule_for, files);
    base::refuse_to_overwrite({opt.rule_file}, files);
    if (opt.rule_file.empty()) base::write_stdout(rule.data(), rule.size());
    else image::write_bytes(opt.rule_file, rule);
}

bool only_rule(const Options& opt) { return !opt.rule_for.empty() && opt.rule_file.empty(); }

// One view under one sky, again after each edit.  last: of the run, which with -watch waits for edits then.
void render_view(Session& s, const Sky& sky, size_t i, bool last) {
    bool whole = false;  // its actions are there, too
    for (int64_t from = s.run.opt.first; !base::shutdown_requested();) {
        Options opt = s.run.opt;
        if (opt.preview) opt.moments = false;
        image::Picture picture = start_picture(opt, sky, i, &s.plan);
        if (is_live(opt)) picture.header.edit = s.run.edits, picture.header.edited = s.run.edited;
        const std::string label = image::label(picture.header);
        const auto draw = [&](int64_t first, int64_t count, const render::GiveFrame& give) {
            render::render_frames(*s.device, s.plan, first, count, opt.moments, give);
        };
        from = render_frames(opt, ends_of(opt, s.control, label), from, picture, draw,
                             render::samples_per_frame(s.plan), s.control, s.report, s.device->name());
        if (!opt.preview && !whole && !s.control.edited()) {
            if (!is_live(opt)) s.report.end();
            whole = render_actions(s, sky, i);
        }
        if (opt.preview || (last && opt.watch)) s.control.wait_for_edit(label, opt.preview);
        if (!s.control.edited() || base::shutdown_requested()) return;
        if (carry_out(s, s.control.take_edits(), sky, i)) from = s.run.opt.first, whole = false;
    }
}

void render_dark(const Options& opt, const Sky& sky) {
    base::finish_on_signal();
    for (size_t i = 0; i < opt.views.size() && !base::shutdown_requested(); ++i) {
        if (is_rendered(opt, i, sky)) continue;
        image::Picture picture = start_picture(opt, sky, i, nullptr);
        write_dark(opt, picture);
        write_dark_actions(opt, picture);
    }
}

// Of each view, whether its picture under each sky is to be rendered by itself.
using Left = std::vector<std::vector<bool>>;

Left all_pictures(const Options& opt) {
    Left left(std::max<size_t>(opt.views.size(), 1), std::vector<bool>(std::max<size_t>(opt.skies.size(), 1), true));
    for (size_t i = 0; i < opt.views.size(); ++i)
        for (size_t k = 0; k < opt.skies.size(); ++k) left[i][k] = !is_rendered(opt, i, opt.skies[k]);
    return left;
}

// Renders the hours of -wea together in the room, and returns what is left; nothing if this run has none to be rendered
// so.
std::optional<Left> render_together(Session& s) {
    const Options& opt = s.run.opt;
    if (only_rule(opt) || !why_apart(opt).empty()) return {};
    if (std::none_of(opt.skies.begin(), opt.skies.end(), [](const Sky& sky) { return sky.light.has_value(); }))
        return {};
    s.text = render::with_sky(std::move(s.text), opt.mean_sky, opt.files);
    if (!s.device) s.device = start(opt.device);
    plan_first(s, {}, 0);
    if (const std::string why = render::why_apart(s.plan); !why.empty()) {
        base::say("ptrace: each hour is rendered by itself: " + why);
        s.plan = {};
        return {};
    }
    warn_of_guesses(s);
    tell_daylight(s, *std::find_if(opt.skies.begin(), opt.skies.end(), [](const Sky& k) { return k.light; }), true);
    Left left = all_pictures(opt);
    if (!opt.rule_for.empty()) write_rule(opt);
    base::finish_on_signal();
    for (size_t i = 0; i < opt.views.size() && !base::shutdown_requested(); ++i) {
        if (i > 0) plan_first(s, {}, i);
        left[i] = render_hours(opt, i, *s.device, s.plan, s.report, plan_action_hours(s, i));
    }
    s.plan = {};
    return left;
}

// Loads the room with this sky.  budget: what the room left of it.  Returns true if something may give light.
bool load_under(Session& s, const Sky& sky, const base::WorkBudget& budget, bool last) {
    const Options& opt = s.run.opt;
    base::Progress progress("ptrace");
    render::Setup setup = setup_of(opt, 0, progress);
    setup.reading.work = std::make_shared<base::WorkBudget>(budget);
    s.text = render::with_sky(std::move(s.text), sky.file, setup.reading);
    const bool is_first = !s.plan.scene.tables;
    s.plan.scene = render::load(*s.device, s.text, setup, s.plan.scene);
    const bool has_light = s.text.scene.may_have_light();
    const bool is_needed = is_live(opt) || !last || opt.views.size() > 1 || opt.pixel || !opt.actions.empty();
    if (!is_needed) s.text.scene = {};
    if (is_first || !is_needed) base::give_back_memory();  // else for the next sky
    return has_light;
}

int render_all(Session& s) {
    choose_focus(s.run.opt);
    const Options& opt = s.run.opt;
    const bool has_other_skies = opt.skies.size() > 1 || !opt.mean_sky.empty();
    s.text = render::read_room(opt.scene_files, opt.files, is_live(opt) || has_other_skies);
    const base::WorkBudget budget = *opt.files.work;
    const std::optional<Left> of_together = render_together(s);
    const Left left = of_together ? *of_together : all_pictures(opt);
    const auto is_done = [](const std::vector<bool>& v) { return std::find(v.begin(), v.end(), true) == v.end(); };
    if (base::shutdown_requested() || std::all_of(left.begin(), left.end(), is_done)) return 0;
    std::vector<Sky> skies = opt.skies.empty() ? std::vector<Sky>(1) : opt.skies;
    for (Sky& sky : skies) sky.beside_shared = of_together.has_value();
    s.run.opt.render.keep_room = is_live(opt) || skies.size() > 1;
    for (const Sky& sky : skies) {
        const bool last = &sky == &skies.back();
        if (base::shutdown_requested()) break;
        const auto is_left = [&, k = size_t(&sky - skies.data())](const auto& view) { return view[k]; };
        const size_t first_view = size_t(std::find_if(left.begin(), left.end(), is_left) - left.begin());
        if (first_view == left.size()) continue;
        if (sky.seed) s.run.opt.render.seed = *sky.seed;
        if (sky.is_black() && !only_rule(opt)) {
            if (!opt.rule_for.empty() && last) write_rule(opt);
            render_dark(opt, sky);
            continue;
        }
        // Files that a scene names are read when it is loaded; so the rule of -M needs a device, too.
        if (!s.device) {
            s.device = start(only_rule(opt) ? "cpu" : opt.device);
            if (is_live(opt)) s.device->heed(&s.control.wish());
            s.control.answer_with([&s](const std::string& words) { answer_what(s, words); });
        }
        const bool has_light = load_under(s, sky, budget, last), is_first = s.plan.fingerprint.empty();
        if (!opt.rule_for.empty() && last && !of_together) write_rule(opt);
        if (only_rule(opt)) continue;
        if (is_first && !has_light) base::warn("scene", "none of its materials gives light: is the sky missing?");
        if (is_first && !of_together) warn_of_guesses(s);
        if (!of_together) tell_daylight(s, sky, is_first);
        s.control.watch(*opt.files.read);
        plan_first(s, sky, first_view);
        if (opt.pixel) return write_pixel(s), 0;
        if (opt.output.empty() && !opt.one_picture && base::stdout_is_file() && &sky == &skies.front())
            base::warn("stdout",
                       "writing frames to a file, which only luxpipe can read; \"| ptaccum -last >\" makes a picture");
        base::finish_on_signal();
        for (size_t i = first_view; i < opt.views.size() && !base::shutdown_requested(); ++i) {
            if (!is_left(left[i])) continue;
            if (i > first_view) plan_first(s, sky, i);
            render_view(s, sky, i, last && i + 1 == opt.views.size());
        }
    }
    return 0;
}

// One state after another, on one device.
int render_states(const Options& opt) {
    std::unique_ptr<device::Device> device;
    for (const scene::State& state : opt.states) {
        Options of_state = opt;
        of_state.scene_files = state.files;
        of_state.state = state.name;
        of_state.last_state = &state == &opt.states.back();
        of_state.files.work = base::work_budget_from_environment();
        Session s(std::move(of_state));
        s.device = std::move(device);
        if (const int status = render_all(s); status != 0 || base::shutdown_requested()) return status;
        device = std::move(s.device);
    }
    return 0;
}

int run(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    return render_states(opt);
}

}  // namespace

int main(int argc, char** argv) {
    base::mark_failure();
    return base::run("ptrace", [&] { return run(argc, argv); });
}
