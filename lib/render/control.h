// SPDX-License-Identifier: BSD-3-Clause
// Commands to ptrace while it renders: the lines of a FIFO (-control), and files of the scene that change (-watch).  A
// thread reads both, so that neither waits for a frame.  It polls the files' state every 10 ms instead of using
// inotify: network folders have no events, every way of saving is covered, and 50 files cost 50 us.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/files_read.h"
#include "device/device.h"
#include "render/command_reader.h"

namespace render {

class Control {
public:
    // fifo: may be empty, for no commands.  Throws Error as base::CommandPipe.  watch: a change of a file is the
    // command "scene".
    Control(const std::string& fifo, bool watch);
    ~Control();
    Control(const Control&) = delete;

    // Returns true if the picture of this label ends with the frame just finished: by "next", "next LABEL" or an edit.
    // After "pause" it waits for "go", "next", an edit, a signal or the end of stdout's reader.  Any other command is
    // an edit, for which the picture ends before this frame.
    bool ends_picture(const std::string& label);
    // The files to watch, as they were read.
    void watch(const base::FilesRead& files);
    // Answers the words of "what", between two frames.
    void answer_with(std::function<void(const std::string& words)> answer) { answer_ = std::move(answer); }
    bool edited() const { return !edits_.empty(); }
    // end: an edit waits, so the current frame need not be finished; wait: it is paused (device::Device::heed).
    const std::atomic<device::Wish>& wish() const { return wish_; }
    bool edit_waits() const { return wish_ == device::Wish::end; }
    bool files_wait() const { return files_wait_; }  // others are asked for, so they need not be read to the end
    // With those that have come since, up to a "next", which is of the picture that goes on if they fail.
    std::vector<Command> take_edits();
    // Called when nothing is left to render: waits for an edit, a signal or, if it ends the picture of this label,
    // "next".
    void wait_for_edit(const std::string& label, bool next_ends);
    // The current picture is a preview, which "go" turns into a full picture.  Edits before "go" are not heard until
    // this time, or the end of its first frame.  texts: that are read for it.
    using Clock = std::chrono::steady_clock;
    void set_preview(bool preview, Clock::time_point deaf_until = {}, base::Overlays texts = {});

private:
    void listen();
    void look_at_files();
    void send(const Command& command);
    std::optional<Command> take(bool next_too);
    bool is_deaf() const;
    bool is_edit(const Command& command) const;
    void look_for_wish();
    void carry_out(const Command& command, const std::string& label);

    std::unique_ptr<CommandReader> reader_;
    std::mutex lock_;
    std::condition_variable arrived_;
    std::deque<Command> commands_;
    std::vector<Command> edits_;  // of ends_picture()
    std::function<void(const std::string& words)> answer_;
    std::atomic<device::Wish> wish_{device::Wish::go_on};
    std::atomic<bool> files_wait_{false};
    bool watch_;
    base::FilesRead files_;
    uint64_t seen_ = 0, told_ = 0;  // states of the files: the last one, and the last one reported
    int steady_ = 0;                // number of looks without a change of state
    std::atomic<bool> leaves_{false};
    bool paused_ = false, ends_ = false, preview_ = false;
    Clock::time_point deaf_until_;
    base::Overlays texts_;
    std::thread thread_;
};

}  // namespace render
