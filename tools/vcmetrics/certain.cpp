// SPDX-License-Identifier: BSD-3-Clause
// From headers to batches (certain.h).
#include "certain.h"

#include <fmt/format.h>

#include "base/error.h"
#include "image/grey.h"

namespace {

constexpr double large_step = 0.4;  // of all frames

// Empty: the picture is a sum that may be one of a row.
std::string what_it_lacks(const image::Picture& p) {
    if (!p.header.frames) return "it is no sum of frames (no FRAMES= line)";
    if (p.header.ranges.size() != 1 || p.header.ranges[0].first != 0 || !p.header.other_seeds.empty())
        return "it is merged from several runs, without their batches (ptaccum -batches 16 keeps them)";
    if (!p.floats) return "it is no stream of float pixels, and no file that ptaccum -batches 16 has made";
    return "";
}

}  // namespace

void Steps::tell(const std::string& place, const std::string& fact) {
    if (!told_) base::warn(place, "no intervals: " + fact);
    told_ = true;
}

// The stream of which a file has kept the sums at the ends of batches.  Looks that the last one would not count any
// more, since half as many frames, are left out.
void Steps::replay(image::Picture& picture, int64_t frames) {
    const auto luminance = [&](std::vector<float>& grey) {
        comfort::Luminance lum;
        lum.width = picture.width, lum.height = picture.height, lum.grey = grey.data();
        return lum;
    };
    certainty_.restart();
    if (!picture.frame0.empty()) {
        image::to_grey(picture.frame0.data(), picture.frame0.size() / 3, picture.frame0.data());
        certainty_.frame0(luminance(picture.frame0));
    }
    for (image::GreyMean& mean : picture.means) {
        comfort::Luminance lum = luminance(mean.grey);
        certainty_.add(lum, mean.frames, frames);
        if (!certainty_.due()) continue;
        if (2 * mean.frames < frames) certainty_.pass_look();
        else certainty_.look(lum, meter_.measure(lum, ""));
    }
}

void Steps::add(image::Picture& picture, const comfort::Luminance& lum, const std::string& place) {
    const bool has_batches = !picture.means.empty();
    const std::string lack = has_batches ? "" : what_it_lacks(picture);
    const int64_t n = picture.header.frames.value_or(0);
    step_ = lack.empty();
    ends_ = has_batches || picture.header.last_frame == n;
    if (!step_) return tell(place, lack);
    if (has_batches) replay(picture, n);
    else if (n == 0 || n <= last_) certainty_.restart();
    if (n == 0) certainty_.frame0(lum);
    else certainty_.add(lum, n, picture.header.last_frame);
    if (!has_batches && !warned_ && last_ >= 16 && double(n - last_) > large_step * double(n)) {
        base::warn(place, fmt::format("{} of {} frames came in one step, which tells little about their error: "
                                      "ptaccum -every x2/16 makes small ones",
                                      n - last_, n));
        warned_ = true;
    }
    last_ = n;
}

bool Steps::look(const comfort::Luminance& lum, const comfort::Measurement& m) {
    if (!step_ || certainty_.batches().count() < 2 || !(ends_ || certainty_.due())) return false;
    const bool counts = certainty_.batches().frames() >= first_look_;
    if (counts) certainty_.look(lum, m);
    else certainty_.pass_look();
    return counts;
}

void Steps::end_input(const std::string& place) {
    if (step_ && certainty_.batches().count() == 1)
        tell(place,
             "a picture by itself holds no batches of frames; the stream of sums does, and a file of "
             "ptaccum -batches 16");
    certainty_.restart();
    last_ = -1;
}
