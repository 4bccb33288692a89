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
#include "base/stop.h"
#include "film/accumulate.h"
#include "image/header.h"
#include "image/stream.h"
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

// Loads the scene on the device, which is started for the first one.
void load(const Options& opt, const scene::Scene& scene, const scene::ReadOptions& how, const std::string& device,
          std::unique_ptr<render::Renderer>& renderer) {
    if (!renderer) renderer = start(device);
    std::vector<render::Shot> shots;
    for (const NamedShot& s : opt.shots) shots.push_back(s.shot);
    base::Progress progress("ptrace");
    render::RenderOptions render = opt.render;
    render.tell_tree = [&](double share) {
        if (progress.due()) progress.show(fmt::format("builds the tree of all surfaces, {:.0f} %", 100 * share));
    };
    renderer->load(scene, shots, render, how);
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

// Frames first to last of the picture that the renderer looks at, unless control ends it before.
void render_frames(const Options& opt, render::Renderer& renderer, render::Control& control, image::Picture& picture) {
    const bool streams = opt.output.empty();
    const std::string label = image::label(picture.header);
    image::WriteOptions as_float;
    as_float.pixels = image::Format::flt;
    Report report(opt.report_s, renderer.device_name(), label, opt.last);
    bool ended = false;
    film::Accumulator sum;
    const auto give = [&](int64_t k, const std::vector<float>& rgb) {
        picture.rgb = rgb;
        picture.header.frame = k;
        const bool ends = k == opt.last || control.ends_picture(label);
        if (ends && streams) picture.header.last_frame = k;
        ended = ended || ends;
        picture.moments = k == 0 && opt.moments ? renderer.moments() : image::Moments();
        if (opt.one_picture) sum.add(picture, fmt::format("frame {}", k));
        else if (streams) image::write_picture_stdout(picture, image::Format::flt);
        else image::write_file(output_name(opt.output, k, label), picture, as_float);
        report.frame(k, k - opt.first + 1);
        return !ended && !base::stop_requested();
    };
    constexpr int64_t block = 1 << 20;  // a bound for the count only: give() says when to stop
    for (int64_t k = opt.first; !ended && !base::stop_requested(); k += block)
        renderer.frames(k, int(std::min(block, opt.last - k + 1)), give);
    if (opt.one_picture) write_sum(opt, sum, label);
}

void write_rule(const Options& opt) {
    const std::string rule = base::make_rule(opt.rule_for, base::files_read());
    if (opt.rule_file.empty()) base::write_stdout(rule.data(), rule.size());
    else image::write_bytes(opt.rule_file, rule);
}

// All views under one sky.
void render_views(const Options& opt, render::Renderer& renderer, render::Control& control,
                  const std::vector<std::string>& history, const std::string& sky) {
    for (size_t i = 0; i < opt.shots.size() && !base::stop_requested(); ++i) {
        const NamedShot& s = opt.shots[i];
        renderer.look(i);
        image::Picture picture;
        picture.width = s.shot.nx;
        picture.height = s.shot.ny;
        for (const std::string& line : history) image::add_history(picture.header, line);
        image::add_history(picture.header, opt.command);
        picture.header.view = s.shot.view;
        picture.header.view_name = s.name;
        if (!sky.empty()) picture.header.sky_name = sky_name(sky);
        picture.header.seed = opt.render.seed;
        picture.header.exposure = opt.exposure;
        picture.header.fingerprint = renderer.fingerprint();
        if (opt.output.empty() && opt.last != Options::endless) picture.header.last_frame = opt.last;
        render_frames(opt, renderer, control, picture);
    }
}

// A file of regions is drawn for each view; masks are of one size.
void choose_focus(Options& opt) {
    if (opt.focus_file.empty()) return;
    image::DrawRegions draw;
    image::MaskSet masks = region::open(opt.focus_file, draw, false);
    for (auto& [name, shot] : opt.shots) {
        if (draw) masks = draw(shot.view, shot.nx, shot.ny);
        shot.focus = render::focus_on(masks, shot.nx, shot.ny, opt.focus_share, opt.focus_file);
        if (shot.focus.empty())
            base::warn(opt.focus_file,
                       "its regions are so large, or -focus-share so small, that none of their pixels gets a "
                       "second sample");
    }
}

int run(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    choose_focus(opt);
    const bool only_rule = !opt.rule_for.empty() && opt.rule_file.empty();
    render::Control control(opt.control);
    std::unique_ptr<render::Renderer> renderer;
    const std::vector<std::string> skies = opt.skies.empty() ? std::vector<std::string>{""} : opt.skies;
    scene::Scene without_sky = scene::read_scene(opt.scene_files, opt.files);
    for (const std::string& sky : skies) {
        scene::Scene scene = &sky == &skies.back() ? std::move(without_sky) : without_sky;
        scene::ReadOptions how = opt.files;
        how.work = std::make_shared<base::Work>(*opt.files.work);  // each sky goes on with what the rest has left
        how.asked_by.clear();                                      // a sky is the command line's
        if (!sky.empty()) scene::read_more(scene, {sky}, how);
        // What a scene names is read when it is loaded; so the rule of -M needs a device, too.
        load(opt, scene, how, only_rule ? "cpu" : opt.device, renderer);
        if (!opt.rule_for.empty() && &sky == &skies.back()) write_rule(opt);
        if (only_rule) continue;
        if (opt.output.empty() && !opt.one_picture && base::stdout_is_file() && &sky == &skies.front())
            base::warn("stdout",
                       "writing frames to a file, which only luxpipe can read; \"| ptaccum -last >\" makes a picture");
        base::finish_on_signal();
        const std::vector<std::string> history = std::move(scene.history);
        scene = scene::Scene();  // the renderer has made its own of it
        base::give_back_memory();
        render_views(opt, *renderer, control, history, sky);
        if (base::stop_requested()) break;
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("ptrace", [&] { return run(argc, argv); });
}
