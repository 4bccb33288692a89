// SPDX-License-Identifier: BSD-3-Clause
// See frames.h.
#include "frames.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "base/progress.h"
#include "base/run.h"
#include "base/shutdown.h"
#include "film/accumulate.h"
#include "image/header.h"
#include "image/stream.h"

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
        if (line_due) base::say("ptrace: " + text);
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

}  // namespace

Ends ends_of(const Options& opt, render::Control& control, const std::string& label) {
    return {opt.first, opt.preview ? 1 : opt.last, [&control, label] { return control.ends_picture(label); }};
}

int64_t render_frames(const Options& opt, const Ends& ends, int64_t from, image::Picture& picture,
                      render::Renderer& renderer, const render::Control& control) {
    const bool streams = opt.output.empty();
    if (streams && ends.last != Options::endless) picture.header.last_frame = ends.last;
    const std::string label = image::label(picture.header);
    image::WriteOptions as_float;
    as_float.pixels = image::Format::flt;
    Report report(opt.report_s, renderer.device_name(), label, ends.last);
    film::Accumulator sum;
    int64_t next = from;
    const auto give = [&](int64_t k, const std::vector<float>& rgb, const image::Moments& moments) {
        const bool is_last = ends.now() || k == ends.last;
        if (control.edited()) return false;
        picture.rgb = rgb;
        picture.header.frame = k;
        if (is_last && streams) picture.header.last_frame = k;
        picture.moments = moments;
        if (opt.one_picture) sum.add(picture, fmt::format("frame {}", k));
        else if (streams) image::write_picture_stdout(picture, image::Format::flt);
        else image::write_file(output_name(opt.output, k, label), picture, as_float);
        report.frame(k, k - ends.first + 1);
        next = is_last ? ends.last + 1 : k + 1;
        return !is_last && !base::shutdown_requested();
    };
    constexpr int64_t block = 1 << 20;  // a bound for the count only: give() says when to stop
    while (next <= ends.last && !control.edited() && !base::shutdown_requested()) {
        renderer.frames(next, std::min(block, ends.last - next + 1), give, opt.moments);
        if (next <= ends.last && control.edit_waits()) ends.now();
    }
    if (opt.one_picture) write_sum(opt, sum, label);
    return next;
}
