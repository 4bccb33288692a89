// SPDX-License-Identifier: BSD-3-Clause
// What is asked of ptrace while it renders: the lines of a FIFO (ptrace -control).  A thread reads them, so that a
// frame can be given up for a command.
#pragma once
#include <atomic>
#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "base/command_pipe.h"

namespace render {

struct Command {
    std::string word, rest;  // the first word of the line, and what follows it
};

class Control {
public:
    // fifo: empty: no commands ever come.  Throws Error as base::CommandPipe.
    explicit Control(const std::string& fifo);
    ~Control();
    Control(const Control&) = delete;

    // Whether the picture of this label ends with the frame that is finished now, by "next" or "next LABEL".  While
    // "pause" holds it waits, for "go", "next", a signal or the end of stdout's reader.  Other words are refused by a
    // warning.
    bool ends_picture(const std::string& label);

private:
    void listen();
    std::optional<Command> take();
    void carry_out(const Command& command, const std::string& label);

    std::unique_ptr<base::CommandPipe> pipe_;
    std::mutex lock_;
    std::condition_variable arrived_;
    std::deque<Command> commands_;
    std::atomic<bool> leaves_{false};
    bool paused_ = false, ends_ = false;
    std::thread thread_;
};

}  // namespace render
