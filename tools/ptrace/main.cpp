// SPDX-License-Identifier: BSD-3-Clause
// ptrace - renders a RADIANCE scene by path tracing, frame after frame, each an ordinary picture on stdout.
// Frame 0 holds the direct and specular paths, frames 1, 2, ... one diffuse path sample a pixel each, more where it
// is noisy (paper Eq. 7); -picture writes their sum instead.
// The rendering lives in lib/render; this file only connects.  See man/ptrace.1.
#include <fmt/core.h>

#include <chrono>
#include <memory>

#include "base/error.h"
#include "base/files_read.h"
#include "base/memory.h"
#include "base/progress.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "base/warnings.h"
#include "film/accumulate.h"
#include "image/header.h"
#include "image/stream.h"
#include "edits.h"
#include "options.h"
#include "region/open.h"
#include "scene/object.h"
#include "render/control.h"
#include "render/progressive.h"

namespace {

using Clock = std::chrono::steady_clock;

// Says how far we are: in place on a terminal, or (-t) a line every so many seconds.
class Report {
public:
    // last: the frame after which it ends; Options::endless: not known.
    Report(int every_s, std::string device, const std::string& label, int64_t last)
        : every_s_(every_s), device_(std::move(device)), what_(label.empty() ? "" : label + ": "), last_(last) {}
    void frame(int64_t k, int64_t done) {
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        const bool line_due = every_s_ > 0 && seconds >= next_s_;
        if (!line_due && !progress_.due()) return;
        const double a_frame = seconds / double(done);
        std::string text = fmt::format("{}frame {}", what_, k);
        if (last_ != Options::endless) text += fmt::format(" of {}", last_);
        text += fmt::format(", {:.1f} s, {:.3g} s a frame, ", seconds, a_frame);
        if (last_ != Options::endless) text += fmt::format("{:.0f} s left, ", a_frame * double(last_ - k));
        text += device_;
        if (line_due) fmt::print(stderr, "ptrace: {}\n", text);
        else progress_.show(text);
        while (line_due && next_s_ <= seconds) next_s_ += every_s_;
    }

private:
    int every_s_;
    std::string device_, what_;
    int64_t last_;
    Clock::time_point start_ = Clock::now();
    double next_s_ = every_s_;
    base::Progress progress_{"ptrace"};
};

// A driver of OpenCL that sees the kernels for the first time compiles them, which takes it some ten seconds; for a GPU
// they are compiled when the scene is known.
std::unique_ptr<render::Renderer> start(const std::string& device) {
    base::Progress progress("ptrace");
    if (device.rfind("opencl", 0) == 0) progress.show("starts " + device + "; its kernels are compiled the first time");
    return std::make_unique<render::Renderer>(device);
}

// A run, from edit to edit.
struct Run {
    Options opt;
    render::Control control{opt.control, opt.watch};
    std::string sky;  // the file; empty: none
    std::unique_ptr<render::Renderer> renderer;
    scene::Scene scene;                // with its sky; where edits may come
    std::vector<std::string> history;  // of the scene
    int64_t edits = 0;
    std::string edited = "start";
    bool live() const { return opt.watch || !opt.control.empty(); }
};

// Loads the scene on the device, which is started for the first one.
void load(const Options& opt, const scene::Scene& scene, const scene::ReadOptions& how, const std::string& device,
          std::unique_ptr<render::Renderer>& renderer) {
    if (!renderer) renderer = start(device);
    std::vector<render::RenderView> views;
    for (const NamedView& s : opt.views) views.push_back(s.render_view);
    base::Progress progress("ptrace");
    render::RenderOptions render = opt.render;
    render.tell_tree = [&](double share) {
        if (progress.due()) progress.show(fmt::format("builds the tree of all surfaces, {:.0f} %", 100 * share));
    };
    renderer->load(scene, views, render, how);
}

// One ordinary picture, as ptaccum -last writes it.
void write_sum(const Options& opt, const film::Accumulator& sum, const std::string& label) {
    if (sum.empty()) return;  // a signal came before frame 0
    image::Picture picture;
    sum.result(picture, !opt.output.empty());
    picture.header.last_frame.reset();
    if (opt.output.empty()) return image::write_picture_stdout(picture, image::Format::rgbe);
    image::add_date(picture.header);
    image::write_file(output_name(opt.output, opt.last, label), picture);
}

// Frames from .. last of the picture that the renderer looks at.  Returns the frame that an edit keeps from being
// written; last + 1: the picture has ended.
int64_t render_frames(Run& run, int64_t from, image::Picture& picture) {
    const Options& opt = run.opt;
    render::Renderer& renderer = *run.renderer;
    const bool streams = opt.output.empty();
    const std::string label = image::label(picture.header);
    image::WriteOptions as_float;
    as_float.pixels = image::Format::flt;
    Report report(opt.report_s, renderer.device_name(), label, opt.last);
    film::Accumulator sum;
    int64_t next = from;
    const auto give = [&](int64_t k, const std::vector<float>& rgb) {
        const bool ends = run.control.ends_picture(label) || k == opt.last;
        if (run.control.edited()) return false;
        picture.rgb = rgb;
        picture.header.frame = k;
        if (ends && streams) picture.header.last_frame = k;
        picture.moments = k == 0 && opt.moments ? renderer.moments() : image::Moments();
        if (opt.one_picture) sum.add(picture, fmt::format("frame {}", k));
        else if (streams) image::write_picture_stdout(picture, image::Format::flt);
        else image::write_file(output_name(opt.output, k, label), picture, as_float);
        report.frame(k, k - opt.first + 1);
        next = ends ? opt.last + 1 : k + 1;
        return !ends && !base::shutdown_requested();
    };
    constexpr int64_t block = 1 << 20;  // a bound for the count only: give() says when to stop
    while (next <= opt.last && !run.control.edited() && !base::shutdown_requested())
        renderer.frames(next, int(std::min(block, opt.last - next + 1)), give);
    if (opt.one_picture) write_sum(opt, sum, label);
    return next;
}

void write_rule(const Options& opt) {
    const std::string rule = base::make_rule(opt.rule_for, base::files_read());
    if (opt.rule_file.empty()) base::write_stdout(rule.data(), rule.size());
    else image::write_bytes(opt.rule_file, rule);
}

// A file of regions is drawn for each view; masks are of one size.
void choose_focus(Options& opt) {
    if (opt.focus_file.empty()) return;
    image::DrawRegions draw;
    image::MaskSet masks = region::open(opt.focus_file, draw, false);
    for (auto& [name, v] : opt.views) {
        if (draw) masks = draw(v.view, v.nx, v.ny);
        v.focus = render::focus_on(masks, v.nx, v.ny, opt.focus_share, opt.focus_file);
        if (v.focus.empty())
            base::warn(opt.focus_file,
                       "its regions are so large, or -focus-share so small, that none of their pixels gets a "
                       "second sample");
    }
}

scene::ReadOptions budget_anew(const Options& opt) {
    scene::ReadOptions how = opt.files;
    how.work = base::work_budget_from_environment();
    return how;
}

// The scene once more from its files, and their present state as the one that changes are told from.
void read_again(Run& run) {
    const std::vector<std::string> before = base::forget_files_read();
    base::take_warnings();
    try {
        scene::ReadOptions how = budget_anew(run.opt);
        scene::Scene scene = scene::read_scene(run.opt.scene_files, how);
        how.asked_by.clear();  // a sky is the command line's
        if (!run.sky.empty()) scene::read_more(scene, {run.sky}, how);
        run.scene = std::move(scene);
    } catch (...) {
        for (const std::string& path : before) base::note_file_read(path);
        throw;
    }
}

// Carries out what waits.  An edit that fails is reported, and what was rendered before goes on.  True: the picture
// begins anew.
bool apply_edits(Run& run, size_t picture) {
    Options next = run.opt;
    const scene::Scene scene = run.scene;
    const std::string before = run.renderer->fingerprint();
    std::string what;
    for (const render::Command& c : run.control.take_edits()) try {
            edit(c, picture, next);
            if (c.word == "scene") read_again(run);
            what = c.word;
        } catch (const base::Error& e) {
            fmt::print(stderr, "ptrace: {}\n", e.text);
        }
    bool good = !what.empty();
    if (good) try {
            choose_focus(next);
            load(next, run.scene, budget_anew(next), next.device, run.renderer);
            run.opt = next;
            run.history = run.scene.history;
        } catch (const base::Error& e) {
            fmt::print(stderr, "ptrace: {}\n", e.text);
            run.scene = scene;
            good = false;
        }
    run.renderer->select_view(picture);
    if (!good || run.renderer->fingerprint() == before) return false;  // frames go on where they were
    run.edits++;
    run.edited = what;
    return true;
}

image::Picture start_picture(const Run& run, const NamedView& s) {
    const Options& opt = run.opt;
    image::Picture picture;
    picture.width = s.render_view.nx;
    picture.height = s.render_view.ny;
    for (const std::string& line : run.history) image::add_history(picture.header, line);
    image::add_history(picture.header, opt.command);
    picture.header.view = s.render_view.view;
    picture.header.view_name = s.name;
    if (!run.sky.empty()) picture.header.sky_name = sky_name(run.sky);
    picture.header.seed = opt.render.seed;
    picture.header.exposure = opt.exposure;
    picture.header.fingerprint = run.renderer->fingerprint();
    if (opt.output.empty() && opt.last != Options::endless) picture.header.last_frame = opt.last;
    if (run.live()) picture.header.edit = run.edits, picture.header.edited = run.edited;
    return picture;
}

// One view under one sky, again after each edit.  last: of the run, which with -watch waits for edits then.
void render_view(Run& run, size_t i, bool last) {
    run.renderer->select_view(i);
    for (int64_t from = run.opt.first; !base::shutdown_requested();) {
        image::Picture picture = start_picture(run, run.opt.views[i]);
        from = render_frames(run, from, picture);
        if (last && run.opt.watch && !run.control.edited()) run.control.wait_for_edit();
        if (!run.control.edited() || base::shutdown_requested()) return;
        if (apply_edits(run, i)) from = run.opt.first;
    }
}

int render_all(Options options) {
    Run run{std::move(options)};
    choose_focus(run.opt);
    const Options& opt = run.opt;
    const bool only_rule = !opt.rule_for.empty() && opt.rule_file.empty();
    const std::vector<std::string> skies = opt.skies.empty() ? std::vector<std::string>{""} : opt.skies;
    scene::Scene without_sky = scene::read_scene(opt.scene_files, opt.files);
    for (const std::string& sky : skies) {
        run.sky = sky;
        scene::Scene scene = &sky == &skies.back() ? std::move(without_sky) : without_sky;
        scene::ReadOptions how = opt.files;
        how.work = std::make_shared<base::WorkBudget>(*opt.files.work);  // each sky goes on with what the rest has left
        how.asked_by.clear();                                            // a sky is the command line's
        if (!sky.empty()) scene::read_more(scene, {sky}, how);
        // What a scene names is read when it is loaded; so the rule of -M needs a device, too.
        load(opt, scene, how, only_rule ? "cpu" : opt.device, run.renderer);
        if (!opt.rule_for.empty() && &sky == &skies.back()) write_rule(opt);
        if (only_rule) continue;
        if (opt.output.empty() && !opt.one_picture && base::stdout_is_file() && &sky == &skies.front())
            base::warn("stdout",
                       "writing frames to a file, which only luxpipe can read; \"| ptaccum -last >\" makes a picture");
        base::finish_on_signal();
        run.history = scene.history;
        if (run.live()) run.scene = std::move(scene);
        scene = scene::Scene();  // the renderer has made its own of it
        base::give_back_memory();
        for (size_t i = 0; i < opt.views.size() && !base::shutdown_requested(); ++i)
            render_view(run, i, &sky == &skies.back() && i + 1 == opt.views.size());
        if (base::shutdown_requested()) break;
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
    return base::run("ptrace", [&] { return run(argc, argv); });
}
