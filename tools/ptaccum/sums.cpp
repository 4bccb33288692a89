// SPDX-License-Identifier: BSD-3-Clause
// See sums.h.
#include "sums.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.h"
#include "base/processors.h"
#include "base/run.h"
#include "image/header.h"
#include "image/grey.h"
#include "image/stream.h"

namespace {
bool writes_png(const Options& options) {
    return std::any_of(options.outputs.begin(), options.outputs.end(),
                       [](const std::string& name) { return image::ending_of(name) == ".png"; });
}

constexpr int files_share = 20;  // without -every the files are written as often as takes a 20th of the time
}  // namespace

Sums::Sums(const Options& options, const Output& output)
    : options_(options), output_(output), schedule_(options.schedule), filters_(options.filter && writes_png(options)) {
    if (options.keeps_parts) parts_.emplace(options.batches ? size_t(*options.batches) : image::most_parts);
}

Sums::Sums(const Options& options, const Output& output, const image::Picture& sum, const std::string& name)
    : Sums(options, output) {
    if (options.until_percent) base::fail("-until", "needs the frames of a whole sum, not a sum that goes on");
    sum_.resume(sum, name);
    filters_ = false;
    const bool is_one_part = sum.parts.empty() && sum_.frames() > 0;
    if (is_one_part && !options.batches) parts_.reset();  // too large a one
    if (parts_ && !sum.parts.empty()) parts_->resume(sum.parts, image::grey_of(sum.rgb), sum_.frames());
    schedule_.resume(sum_.frames()), of_parts_.resume(sum_.frames());
}

void Sums::add(const image::Picture& frame, const std::string& place) {
    const bool restarts = sum_.restarts(frame.header) || (sum_.empty() && frame.header.frame == 0);
    if (sum_.empty()) output_.require_names_for(frame.header);
    if (sum_.empty() && output_.leaves_a_pipe() && !frame.header.last_frame)
        base::warn("stdout", "receives nothing when -o is used; add -o - to pass the sums on");
    const bool edited = frame.header.edit != sum_.header().edit;  // nobody waits for the rest of what came before
    if (restarts && !sum_.empty()) {                              // the last picture of what came before
        if (!edited) end_stream();
        if (image::label(frame.header) != image::label(sum_.header())) end_files();
    }
    sum_.add(frame, place);
    if (restarts && parts_) parts_->restart();
    if (options_.until_percent && !image::label(frame.header).empty())
        base::fail("-until", "ends with the first sum, and these frames are of several views, skies or actions");
    if (options_.until_percent && restarts) blocks_.restart(frame);
    else if (options_.until_percent) blocks_.add(frame);
    if (filters_ && frame.header.frame == 0) halves_.clear(frame.rgb.size());
    else if (filters_) halves_.add(frame.rgb);
    if (restarts) schedule_.restart(), of_parts_.restart(), moments_streamed_ = false;
    streamed_ = filed_ = false;
    if (output_.to_stdout() && base::stdout_is_closed()) throw base::ClosedPipe{};  // the next write may be far
    const bool parts_due = parts_ && of_parts_.due(sum_.frames());
    if (schedule_.due(sum_.frames())) write_due();
    else if (parts_due) take_sum(false);
    if (progress_.due()) progress_.show(fmt::format("{} frames", sum_.frames()));
}

bool Sums::done() const { return options_.until_percent && 100 * blocks_.relative() <= *options_.until_percent; }

void Sums::write_due() {
    const bool to_stdout = output_.to_stdout() && !options_.last_only;
    if (to_stdout) stream_sum(false);
    else if (parts_) take_sum(false);
    if (options_.last_only) return;
    if (options_.outputs.empty() || (!options_.every_given && Clock::now() < files_again_)) return;
    const Clock::time_point began = Clock::now();
    write_files(true);
    files_again_ = Clock::now() + files_share * (Clock::now() - began);
}

void Sums::end_stream() {
    if (!streamed_ && output_.to_stdout()) stream_sum(options_.last_only);
}

void Sums::take_sum(bool with_parts) {
    sum_.result(result_, with_parts);
    if (!parts_) return;
    const std::vector<float> grey = image::grey_of(result_.rgb);
    const int64_t first = result_.header.ranges.front().first;
    parts_->add(grey.data(), grey.size(), sum_.frames(), result_.header.seed, std::max<int64_t>(first, 1));
    if (with_parts) result_.parts = parts_->parts();
}

void Sums::stream_sum(bool by_itself) {
    take_sum(false);
    if (!moments_streamed_) result_.moments = sum_.moments();
    moments_streamed_ = true;
    if (by_itself) output_.stdout_picture(result_);
    else output_.stream_picture(result_);
    const auto& last = result_.header.last_frame;
    seems_whole_ = !last || result_.header.ranges.back().second >= *last;
    streamed_ = true;
}

void Sums::break_off() {
    if (seems_whole_) base::write_stdout("#?RADIANCE\n", 11);
}

void Sums::warn_of_stream_in_file() const {
    if (options_.last_only || options_.floats || options_.bytes || !output_.to_stdout() || !base::stdout_is_file())
        return;
    base::warn("stdout",
               "all sums were written to the file, as floats that only luxpipe reads; -last writes a single picture");
}

// A sum that lacks frame 0 is no picture, and two frames tell nothing of their noise.
bool Sums::can_filter() const {
    return filters_ && !result_.frame0.empty() && halves_.frames() >= display::HalfSums::least_frames;
}

void Sums::write_files(bool passing) {
    take_sum(true);
    if (passing || !can_filter()) return output_.files(result_, passing);
    const std::vector<float> filtered =
        display::denoised(halves_, result_.frame0, result_.width, result_.height, base::processors());
    output_.files(result_, passing, &filtered);
}

void Sums::end_files() {
    if (filed_ || options_.outputs.empty()) return;
    write_files(false);
    filed_ = true;
}
