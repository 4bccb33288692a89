// SPDX-License-Identifier: BSD-3-Clause
// See sum.h.
#include "report/sum.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace report {
namespace {

constexpr double large_step = 0.4;  // of all frames

// Empty: the picture is a sum that may be one of a row.
std::string what_it_lacks(const image::Picture& p) {
    if (!p.parts.empty()) return "";
    if (!p.header.frames) return "it is no sum of frames (no FRAMES= line)";
    if (p.header.ranges.size() != 1 || p.header.ranges[0].first != 0 || !p.header.other_seeds.empty())
        return "it is merged from several runs, without their batches (ptaccum -batches 16 -o file.exr keeps them)";
    if (!p.floats)
        return "its pixels are not floats, which tell too little (leave out -last and -fc of ptaccum; of a file: "
               "ptaccum -o file.exr)";
    return "";
}

void report_lack(Sum& sum, const std::string& place, const std::string& fact) {
    if (!std::exchange(sum.reported, true)) base::warn(place, "no intervals: " + fact);
}

Sum another(const Sum& before) {
    Sum out;
    out.reported = before.reported, out.warned = before.warned;
    return out;
}

}  // namespace

Sum add(Sum sum, const image::Picture& picture, const glare::Reading& reading, const std::string& place, bool reports,
        bool passes) {
    const bool has_parts = !picture.parts.empty();
    const std::string lack = what_it_lacks(picture);
    const int64_t n = picture.header.frames.value_or(0), before = sum.last;
    sum.step = lack.empty(), sum.looked = false;
    if (!sum.step) {
        if (reports) report_lack(sum, place, lack);
        return sum;
    }
    if (has_parts || n == 0 || n <= before) sum = another(sum);
    sum.step = true, sum.ends = has_parts || picture.header.last_frame == n, sum.last = n;
    if (has_parts) sum.taken = picture.parts;
    else if (n > 0) sum.growing.add(reading.lum.grey, reading.lum.size(), n, picture.header.seed);
    const int64_t m = picture.header.direct_frames.value_or(image::direct_samples);
    // Later pictures know less of it, but those of so few frames that each range stays a part of its own.
    const bool known_later = passes && *picture.header.last_frame <= std::min(m, int64_t(image::most_parts));
    if (has_parts || (n > 0 && n <= m && !known_later)) {
        const glare::Geometry& g = reading.geometry();
        uncertainty::Frame0Error error = uncertainty::frame0_error(sum.parts(), m, g.width, g.height, counts(g));
        if (!error.of_pixel.empty()) sum.frame0_error = std::move(error);
    }
    if (!has_parts && before >= 16 && double(n - before) > large_step * double(n) && !std::exchange(sum.warned, true))
        base::warn(place,
                   fmt::format("{} of {} frames came in one step, from which their error cannot be estimated well: "
                               "ptaccum -every x2/16 makes small ones",
                               n - before, n));
    return sum;
}

Sum look(Sum sum, const glare::Reading& reading, const glare::Measurement& m, const std::vector<glare::Column>& columns,
         int64_t first_look) {
    constexpr double growth_between_looks = 1.41421356;
    const int64_t frames = image::frames_of(sum.parts());
    const bool due = sum.again || frames >= sum.next_look;
    if (!sum.step || sum.parts().size() < 2 || !(sum.ends || due)) return sum;
    if (frames >= sum.next_look)
        sum.next_look = std::max(frames + 1, int64_t(std::llround(double(frames) * growth_between_looks)));
    sum.again = false, sum.looked = frames >= first_look;
    if (sum.looked) sum.look = look(reading, m, columns, sum.parts(), sum.frame0_error, sum.look);
    return sum;
}

Sum without_look(Sum sum) {
    sum.look = {}, sum.again = true;
    return sum;
}

Sum end_input(Sum sum, const std::string& place, bool reports) {
    if (reports && sum.step && sum.parts().size() == 1) report_lack(sum, place, no_batches);
    return another(sum);
}

}  // namespace report
