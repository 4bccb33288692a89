// SPDX-License-Identifier: BSD-3-Clause
// See frames.h.
#include "frames.h"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.h"
#include "base/shutdown.h"
#include "film/accumulate.h"
#include "image/header.h"
#include "image/stream.h"
#include "render/progressive.h"

namespace {

// Names points that none of their first samples has found light for.  Shadows are no news under direct light alone.
class DarkPoints {
public:
    DarkPoints(const Options& opt, uint32_t samples_per_frame)
        : opt_(opt), of_frame_(samples_per_frame), lit_(opt.render.ab > 0 ? image::count_of(opt.grids) : 0) {}
    void add(const std::vector<float>& frame) {
        if (lit_.empty()) return;
        for (size_t i = 0; i < lit_.size(); ++i)
            lit_[i] = lit_[i] || frame[3 * i] != 0 || frame[3 * i + 1] != 0 || frame[3 * i + 2] != 0;
        samples_ += of_frame_;
        if (samples_ < enough) return;
        for (size_t g = 0; g < opt_.grids.size(); ++g)
            for (size_t i = 0; i < opt_.grids[g].count; ++i)
                if (!lit_[opt_.grids[g].first + i]) warn(opt_.grid_files[g], i);
        lit_.clear();
    }

private:
    static constexpr uint32_t enough = 64;  // samples
    const Options& opt_;
    uint32_t of_frame_, samples_ = 0;
    std::vector<bool> lit_;
    static void warn(const image::GridFile& file, size_t i) {
        base::warn(fmt::format("{}:{}", file.path, file.points[i].line),
                   "no light arrives at this point: is it inside a solid, or below the ground?");
    }
};

// The picture of an action is called as the ordinary one with the action behind it, "desk_mel.hdr", as ptaccum has it.
std::string file_of(const Options& opt, image::Header header, int64_t k) {
    const std::string of_action = header.action ? "_" + header.action->name : "";
    header.action.reset();
    std::string name = output_name(opt.output, k, image::label(header));
    return name.insert(name.size() - image::ending_of(name).size(), of_action);
}

void write_to(const Options& opt, const std::string& file, const image::Picture& picture, image::WriteOptions how) {
    base::refuse_to_overwrite({file}, base::paths_of(*opt.files.read));
    image::write_file(file, picture, how);
}

}  // namespace

image::Picture start_picture(const Options& opt, const Sky& sky, size_t i, const render::ViewPlan* plan) {
    const render::RenderView& v = opt.views[i].render_view;
    image::Picture picture;
    picture.width = plan ? plan->nx : v.nx;
    picture.height = plan ? plan->ny : v.ny;
    if (plan)
        for (const std::string& line : plan->scene.history) image::add_history(picture.header, line);
    image::add_history(picture.header, opt.command);
    for (const std::string& line : sky.lines) image::add_history(picture.header, line);
    if (!v.points) picture.header.view = v.view;
    picture.header.grids = opt.grids;
    picture.header.view_name = opt.views[i].name;
    picture.header.sky_name = sky.name;
    picture.header.state = opt.state;
    picture.header.hour = sky.hour;
    picture.header.unknown = sky.unknown;
    if (sky.beside_shared) picture.header.shared_paths = image::no_shared_paths;
    picture.header.seed = opt.render.seed;
    picture.header.exposure = opt.exposure;
    if (!plan) return picture;
    picture.header.fingerprint = plan->fingerprint;
    picture.header.direct_frames = plan->m;
    return picture;
}

// One ordinary picture, as ptaccum -last writes it.
void write_sum(const Options& opt, const film::Accumulator& sum) {
    if (sum.empty()) return;  // a signal came before frame 0
    image::Picture picture;
    sum.result(picture, !opt.output.empty());
    picture.header.last_frame.reset();
    image::WriteOptions how;
    if (image::needs_floats(picture.header)) how.pixels = image::Format::flt;
    if (opt.output.empty()) return image::write_picture_stdout(picture, how.pixels);
    image::add_date(picture.header);
    write_to(opt, file_of(opt, picture.header, opt.last), picture, how);
}

void write_frame(const Options& opt, const image::Picture& frame, film::Accumulator& sum) {
    const int64_t k = *frame.header.frame;
    image::WriteOptions as_float;
    as_float.pixels = image::Format::flt;
    if (opt.one_picture) sum.add(frame, fmt::format("frame {}", k));
    else if (opt.output.empty()) image::write_picture_stdout(frame, image::Format::flt);
    else write_to(opt, file_of(opt, frame.header, k), frame, as_float);
}

Ends ends_of(const Options& opt, render::Control& control, const std::string& label) {
    return {opt.first, opt.preview ? 1 : opt.last, [&control, label] { return control.ends_picture(label); }};
}

void write_dark(const Options& opt, image::Picture& picture) {
    const size_t pixels = size_t(picture.width) * size_t(picture.height);
    picture.rgb.assign(3 * pixels, 0);
    picture.header.frame = opt.first;
    if (opt.output.empty()) picture.header.last_frame = opt.first;
    if (opt.moments && opt.first == 0 && !picture.header.action)
        picture.moments = std::make_shared<std::vector<float>>(image::moment_numbers * pixels);
    film::Accumulator sum;
    write_frame(opt, picture, sum);
    if (opt.one_picture) write_sum(opt, sum);
}

int64_t render_frames(const Options& opt, const Ends& ends, int64_t from, image::Picture& picture,
                      const DrawFrames& draw, uint32_t samples, const render::Control& control, Report& report,
                      const std::string& device) {
    const bool streams = opt.output.empty();
    if (streams && ends.last != Options::endless) picture.header.last_frame = ends.last;
    const std::string label = image::label(picture.header);
    report.begin(label, device, ends.first, ends.last);
    DarkPoints dark(opt, samples);
    film::Accumulator sum;
    int64_t next = from;
    const auto give = [&](int64_t k, const std::vector<float>& rgb, const image::Moments& moments) {
        const bool is_last = ends.now() || k == ends.last;
        if (control.edited()) return false;
        if (k > 0 && !picture.header.action) dark.add(rgb);
        picture.rgb = rgb;
        picture.header.frame = k;
        if (is_last && streams) picture.header.last_frame = k;
        picture.moments = moments;
        write_frame(opt, picture, sum);
        report.frame(k);
        next = is_last ? ends.last + 1 : k + 1;
        return !is_last && !base::shutdown_requested();
    };
    constexpr int64_t block = 1 << 20;  // a bound for the count only: give() says when to stop
    while (next <= ends.last && !control.edited() && !base::shutdown_requested()) {
        try {
            draw(next, std::min(block, ends.last - next + 1), give);
        } catch (const device::Cancelled&) {}
        if (next <= ends.last && control.edit_waits()) ends.now();
    }
    if (opt.one_picture) write_sum(opt, sum);
    return next;
}
