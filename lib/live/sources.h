// SPDX-License-Identifier: BSD-3-Clause
// The glare sources of the newest picture, by the program that measures the stream: `vcmetrics -sources` with the same
// options runs on the picture beside the pipe, when the page asks, so that its numbers are the program's own.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>
#include "live/live.h"

namespace live {

// From the program after "--": its options that concern sources, and -sources.
std::vector<std::string> sources_command(const std::vector<std::string>& command);

class Sources {
public:
    // found: called when an answer is there, from a thread of its own.
    Sources(const Live& live, std::vector<std::string> command, std::function<void()> found);
    ~Sources();
    Sources(const Sources&) = delete;

    struct Found {
        size_t picture = 0;
        int status = 0;
        std::string lines;  // a JSON object each
    };
    // Sources of this picture or of a newer one.  Nothing: they are not known yet, and a search begins.
    std::optional<Found> of(size_t picture);

private:
    void work();
    Found measure() const;
    const Live& live_;
    const std::vector<std::string> command_;
    std::function<void()> found_call_;
    std::mutex mutex_;
    std::condition_variable asked_;
    bool wanted_ = false, ends_ = false;
    Found found_;
    std::thread thread_;
};

}  // namespace live
