// SPDX-License-Identifier: BSD-3-Clause
// See asked.h.
#include "live/asked.h"

namespace live {

Asked::Asked(std::function<Found()> find, std::function<void()> found)
    : find_(std::move(find)), found_call_(std::move(found)), thread_([this] { work(); }) {}

Asked::~Asked() {
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        ends_ = true;
    }
    asked_.notify_all();
    thread_.join();
}

std::optional<Asked::Found> Asked::of(size_t picture) {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (found_.picture > 0 && found_.picture >= picture) return found_;
    wanted_ = true;
    asked_.notify_all();
    return std::nullopt;
}

void Asked::work() {
    for (;;) {
        {
            std::unique_lock<std::mutex> lock(mutex_);
            asked_.wait(lock, [this] { return wanted_ || ends_; });
            if (ends_) return;
            wanted_ = false;
        }
        Found found = find_();
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            found_ = std::move(found);
        }
        found_call_();
    }
}

}  // namespace live
