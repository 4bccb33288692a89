// SPDX-License-Identifier: BSD-3-Clause
// ptrace - renders a RADIANCE scene by path tracing, frame after frame, each an ordinary picture on stdout.
// Frame 0 holds the direct and specular paths, frames 1, 2, ... one diffuse path sample a pixel each (paper Eq. 7).
// The rendering lives in lib/trace; this file only connects.  See man/ptrace.1.
#include <fmt/core.h>

#include <chrono>

#include "base/error.h"
#include "base/files_read.h"
#include "base/progress.h"
#include "base/run.h"
#include "base/stop.h"
#include "image/header.h"
#include "image/stream.h"
#include "options.h"
#include "scene/object.h"
#include "trace/progressive.h"

namespace {

using Clock = std::chrono::steady_clock;

// Says how far we are: in place on a terminal, or (-t) a line every so many seconds.
class Report {
public:
    // last: the frame after which it ends; Options::endless: not known.
    Report(int every_s, std::string device, int64_t last)
        : every_s_(every_s), device_(std::move(device)), last_(last) {}
    void frame(int64_t k, int64_t done) {
        const double seconds = std::chrono::duration<double>(Clock::now() - start_).count();
        const bool line_due = every_s_ > 0 && seconds >= next_s_;
        if (!line_due && !progress_.due()) return;
        const double a_frame = seconds / double(done);
        std::string text = fmt::format("frame {}", k);
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
    std::string device_;
    int64_t last_;
    Clock::time_point start_ = Clock::now();
    double next_s_ = every_s_;
    base::Progress progress_{"ptrace"};
};

// What the scene names is read when it is flattened; so a renderer is made, but not used.
void print_rule(const scene::Scene& scene, const Options& opt) {
    const trace::Renderer reads_the_rest(scene, opt.view, 1, 1, opt.render, "cpu", opt.files);
    const std::string rule = base::make_rule(opt.rule_for, base::files_read());
    base::write_stdout(rule.data(), rule.size());
}

int render(int argc, char** argv) {
    Options opt;
    if (auto status = parse_options(argc, argv, opt)) return *status;
    const scene::Scene scene = scene::read_scene(opt.scene_files, opt.files);
    if (!opt.rule_for.empty()) {
        print_rule(scene, opt);
        return 0;
    }
    trace::Renderer renderer(scene, opt.view, opt.nx, opt.ny, opt.render, opt.device, opt.files);

    image::Picture picture;
    picture.width = opt.nx;
    picture.height = opt.ny;
    for (const std::string& line : scene.history) image::add_history(picture.header, line);
    image::add_history(picture.header, opt.command);
    picture.header.view = opt.view;
    picture.header.seed = opt.render.seed;
    picture.header.exposure = opt.exposure;
    picture.header.fingerprint = renderer.fingerprint();
    const bool streams = opt.output.empty();
    if (streams && opt.last != Options::endless) picture.header.last_frame = opt.last;
    image::WriteOptions as_float;
    as_float.pixels = image::Format::flt;
    Report report(opt.report_s, renderer.device_name(), opt.last);
    const auto give = [&](int64_t k, const std::vector<float>& rgb) {
        picture.rgb = rgb;
        picture.header.frame = k;
        if (streams) image::write_picture_stdout(picture, image::Format::flt);
        else image::write_file(output_name(opt.output, k), picture, as_float);
        report.frame(k, k - opt.first + 1);
        return k < opt.last && !base::stop_requested();
    };
    if (streams && base::stdout_is_file())
        base::warn("stdout",
                   "writing frames to a file, which only luxpipe can read; \"| ptaccum -last >\" makes a picture");
    base::finish_on_signal();
    constexpr int64_t block = 1 << 20;  // a bound for the count only: give() says when to stop
    for (int64_t k = opt.first; k <= opt.last && !base::stop_requested(); k += block)
        renderer.frames(k, int(std::min(block, opt.last - k + 1)), give);
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    return base::run("ptrace", [&] { return render(argc, argv); });
}
