// SPDX-License-Identifier: BSD-3-Clause
// A question about the newest picture that is answered in a while, in a thread of its own.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace live {

class Asked {
public:
    struct Found {
        size_t picture = 0;
        int status = 0;  // of the program that was asked
        std::string text;
    };
    // found: called when an answer is there, from that thread.
    Asked(std::function<Found()> find, std::function<void()> found);
    ~Asked();
    Asked(const Asked&) = delete;

    // The answer for this picture or for a newer one.  Nothing: it is not known yet, and the search begins.
    std::optional<Found> of(size_t picture);

private:
    void work();
    const std::function<Found()> find_;
    const std::function<void()> found_call_;
    std::mutex mutex_;
    std::condition_variable asked_;
    bool wanted_ = false, ends_ = false;
    Found found_;
    std::thread thread_;
};

}  // namespace live
