// SPDX-License-Identifier: BSD-3-Clause
// A question about the newest picture that is answered in a while, in a thread of its own.
#pragma once
#include <optional>
#include <string>
#include "live/worker.h"

namespace live {

class Asked {
public:
    struct Found {
        size_t picture = 0;
        int status = 0;  // of the program that was asked
        std::string text;
    };
    // found: called when an answer is there, from that thread.
    Asked(std::function<Found()> find, std::function<void()> found)
        : worker_([this, find = std::move(find), found = std::move(found)] {
              Found now = find();
              {
                  const std::lock_guard<std::mutex> lock(mutex_);
                  found_ = std::move(now);
              }
              found();
          }) {}

    // The answer for this picture or for a newer one.  Nothing: it is not known yet, and the search begins.
    std::optional<Found> of(size_t picture) {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (found_.picture > 0 && found_.picture >= picture) return found_;
        worker_.ask();
        return std::nullopt;
    }

private:
    std::mutex mutex_;
    Found found_;
    Worker worker_;
};

}  // namespace live
