// SPDX-License-Identifier: BSD-3-Clause
// See certain.h.
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
    if (!p.floats)
        return "its pixels are not floats, which tell too little (leave out -last and -fc of ptaccum; of a file: "
               "ptaccum -batches 16 -o file.exr)";
    return "";
}

}  // namespace

void Steps::tell(const std::string& place, const std::string& fact) {
    if (!told_ && tells_) base::warn(place, "no intervals: " + fact);
    told_ = true;
}

void Steps::add(const image::Picture& picture, const glare::Luminance& lum, const std::string& place) {
    const bool has_parts = !picture.parts.empty();
    const std::string lack = has_parts ? "" : what_it_lacks(picture);
    const int64_t n = picture.header.frames.value_or(0);
    step_ = lack.empty();
    ends_ = has_parts || picture.header.last_frame == n;
    if (!step_) return tell(place, lack);
    if (has_parts || n == 0 || n <= last_) estimates_.restart();
    if (has_parts) estimates_.take(picture.parts);
    else if (n > 0) estimates_.add(lum, n, picture.header.seed);
    if (!has_parts && !warned_ && last_ >= 16 && double(n - last_) > large_step * double(n)) {
        base::warn(place,
                   fmt::format("{} of {} frames came in one step, from which their error cannot be estimated well: "
                               "ptaccum -every x2/16 makes small ones",
                               n - last_, n));
        warned_ = true;
    }
    last_ = n;
}

bool Steps::look(const glare::Luminance& lum, const glare::Measurement& m) {
    if (!step_ || estimates_.parts().size() < 2 || !(ends_ || estimates_.due())) return false;
    const bool counts = estimates_.frames() >= first_look_;
    if (counts) estimates_.look(lum, m);
    else estimates_.pass_look();
    return counts;
}

void Steps::end_input(const std::string& place) {
    if (step_ && estimates_.parts().size() == 1)
        tell(place,
             "a picture by itself holds no batches of frames; the stream of sums does (ptaccum without -last), and a "
             "file of ptaccum -batches 16 -o file.exr");
    estimates_.restart();
    last_ = -1;
}
