// SPDX-License-Identifier: BSD-3-Clause
// From headers to batches (certain.h).
#include "certain.h"

#include <fmt/format.h>

#include "base/error.h"

namespace {

constexpr double large_step = 0.4;  // of all frames

// Empty: the picture is a sum that may be one of a row.
std::string what_it_lacks(const image::Picture& p) {
    if (!p.header.frames) return "it is no sum of frames (no FRAMES= line)";
    if (p.header.ranges.size() != 1 || p.header.ranges[0].first != 0 || !p.header.other_seeds.empty())
        return "it is merged from several runs, whose batches are not in it";
    if (!p.floats) return "its pixels are no 32-bit floats in a stream, and too coarse to tell sums apart";
    return "";
}

}  // namespace

void Steps::tell(const std::string& place, const std::string& fact) {
    if (!told_) base::warn(place, "no intervals: " + fact);
    told_ = true;
}

void Steps::add(const image::Picture& picture, const comfort::Luminance& lum, const std::string& place) {
    const std::string lack = what_it_lacks(picture);
    const int64_t n = picture.header.frames.value_or(0);
    step_ = lack.empty();
    if (!step_) return tell(place, lack);
    if (n == 0 || n <= last_) certainty_.restart();
    if (n == 0) certainty_.frame0(lum);
    else certainty_.add(lum, n);
    if (!warned_ && last_ >= 16 && double(n - last_) > large_step * double(n)) {
        base::warn(place, fmt::format("{} of {} frames came in one step, which tells little about their error: "
                                      "ptaccum -every x2/16 makes small ones",
                                      n - last_, n));
        warned_ = true;
    }
    last_ = n;
}

bool Steps::look(const comfort::Luminance& lum, const comfort::Measurement& m) {
    if (!step_ || !certainty_.due()) return false;
    certainty_.look(lum, m);
    return true;
}

void Steps::end_input(const std::string& place) {
    if (step_ && certainty_.batches().count() == 1)
        tell(place, "a picture by itself holds no batches of frames; the stream of sums does");
    certainty_.restart();
    last_ = -1;
}
