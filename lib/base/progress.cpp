// SPDX-License-Identifier: BSD-3-Clause
// See progress.h.
#include "base/progress.h"

#include <cstdio>

#include "base/descriptor.h"

namespace base {

using Clock = std::chrono::steady_clock;

Progress::Progress(std::string tool) : tool_(std::move(tool)), shown_(is_terminal(2)), next_(Clock::now()) {}
Progress::~Progress() { clear(); }

bool Progress::due() const { return shown_ && Clock::now() >= next_; }

void Progress::show(const std::string& text) {
    if (!shown_) return;
    std::fprintf(stderr, "\r\033[K%s: %s", tool_.c_str(), text.c_str());
    dirty_ = true;
    next_ = Clock::now() + std::chrono::milliseconds(200);
}

void Progress::clear() {
    if (dirty_) std::fprintf(stderr, "\r\033[K");
    dirty_ = false;
}

}  // namespace base
