// SPDX-License-Identifier: BSD-3-Clause
// A pipe of our own children: ptrace renders, ptaccum sums, the sums pass through here to vcmetrics.  Picture, day and
// plan are three of these; what they say becomes events of the state.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <functional>
#include <mutex>
#include <string>
#include <vector>

#include "live/live.h"
#include "live/outbox.h"
#include "live/worker.h"

namespace live {

using Words = std::vector<std::string>;

struct Command {
    Words render, sum, measure;  // measure: empty for sums that go to a file
};

// Lines of a descriptor until it ends, or the taker of one says false.
void read_lines(int descriptor, const std::function<bool(const std::string&)>& take);

class Programs {
public:
    // ended: they have, and are not started again by themselves.
    Programs(Which which, Command command, Live& live, std::function<void()> ended);
    ~Programs();  // they end before
    Programs(const Programs&) = delete;
    void start();
    void send(const std::string& bytes) { commands_.put(bytes); }

private:
    void run();
    void pass_sums(int sums, int measure);
    bool take_row(const std::string& line);
    void end_render();
    const Which which_;
    const Command command_;
    Live& live_;
    const std::function<void()> ended_;
    std::mutex mutex_;
    std::atomic<bool> ends_{false};
    pid_t render_ = -1;
    Outbox commands_;
    Worker worker_;
};

}  // namespace live
