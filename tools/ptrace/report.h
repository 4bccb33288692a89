// SPDX-License-Identifier: BSD-3-Clause
// Progress of a run: in place on a terminal, or (-t) a line on the standard error every so many seconds.
#pragma once
#include <chrono>
#include <cstdint>
#include <string>

#include "base/progress.h"

class Report {
public:
    // pictures: of the run, views times skies that are not dark.
    Report(int every_s, size_t pictures) : every_s_(every_s), pictures_(pictures), next_s_(every_s) {}
    // A picture of frames first to last (Options::endless: not known), or the same one once more.
    void begin(const std::string& label, const std::string& device, int64_t first, int64_t last);
    void frame(int64_t k);  // has been written
    void end() { ++done_; }

private:
    using Clock = std::chrono::steady_clock;
    std::string text(int64_t k) const;

    int every_s_;
    size_t pictures_, done_ = 0;
    std::string what_, device_;
    int64_t first_ = 0, last_ = 0;
    Clock::time_point start_ = Clock::now(), picture_start_;
    double next_s_;
    base::Progress progress_{"ptrace"};
};
