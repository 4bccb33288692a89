// SPDX-License-Identifier: BSD-3-Clause
// See report.h.
#include "report.h"

#include <fmt/format.h>

#include "base/run.h"
#include "options.h"

static double seconds_since(std::chrono::steady_clock::time_point t) {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

void Report::begin(const std::string& label, const std::string& device, int64_t first, int64_t last) {
    what_ = label.empty() ? "" : label + ": ";
    device_ = device;
    first_ = first, last_ = last;
    picture_start_ = Clock::now();
}

std::string Report::text(int64_t k) const {
    const double seconds = seconds_since(picture_start_), a_frame = seconds / double(k - first_ + 1);
    std::string text = fmt::format("{}frame {}", what_, k);
    if (last_ == Options::endless)
        return text + fmt::format(", {:.1f} s, {:.3g} s a frame, {}", seconds, a_frame, device_);
    text += fmt::format(" of {}", last_);
    if (pictures_ > 1) text += fmt::format(", picture {} of {}", done_ + 1, pictures_);
    // Each of several pictures is expected to take as long as those before.
    const double share = double(k - first_ + 1) / double(last_ - first_ + 1);
    const double left = pictures_ > 1 ? seconds_since(start_) * (double(pictures_) / (double(done_) + share) - 1)
                                      : a_frame * double(last_ - k);
    return text + fmt::format(", {:.1f} s, {:.3g} s a frame, {:.0f} s left, {}", seconds, a_frame, left, device_);
}

void Report::frame(int64_t k) {
    const double seconds = seconds_since(start_);
    if (every_s_ > 0 && seconds >= next_s_) {
        base::say("ptrace: " + text(k));
        while (next_s_ <= seconds) next_s_ += every_s_;
    } else if (progress_.due()) {
        progress_.show(text(k));
    }
}
