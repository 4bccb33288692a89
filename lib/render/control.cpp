// SPDX-License-Identifier: BSD-3-Clause
// See control.h.
#include "render/control.h"

#include <chrono>

#include "base/error.h"
#include "base/printable.h"
#include "base/run.h"
#include "base/stop.h"

namespace render {
namespace {

constexpr int patience_ms = 100;  // how long a thread may wait without a look at what else there is

// "  next desk " is next, desk.
Command parse(const std::string& line) {
    const char* blanks = " \t\r";
    const size_t from = line.find_first_not_of(blanks);
    if (from == std::string::npos) return {};
    const size_t end = line.find_first_of(blanks, from), rest = line.find_first_not_of(blanks, end);
    if (rest == std::string::npos) return {line.substr(from, end - from), ""};
    return {line.substr(from, end - from), line.substr(rest, line.find_last_not_of(blanks) + 1 - rest)};
}

}  // namespace

Control::Control(const std::string& fifo) {
    if (fifo.empty()) return;
    pipe_ = std::make_unique<base::CommandPipe>(fifo);
    thread_ = std::thread([this] { listen(); });
}

Control::~Control() {
    leaves_ = true;
    if (thread_.joinable()) thread_.join();
}

void Control::listen() {
    while (!leaves_) {
        try {
            while (const auto line = pipe_->line()) {
                const Command command = parse(*line);
                if (command.word.empty()) continue;
                const std::lock_guard<std::mutex> hold(lock_);
                commands_.push_back(command);
                arrived_.notify_all();
            }
        } catch (const base::Error& e) {
            base::warn(e.where, e.message);
        }
        pipe_->wait(patience_ms);
    }
}

std::optional<Command> Control::take() {
    std::unique_lock<std::mutex> hold(lock_);
    if (paused_ && commands_.empty()) arrived_.wait_for(hold, std::chrono::milliseconds(patience_ms));
    if (commands_.empty()) return std::nullopt;
    Command command = commands_.front();
    commands_.pop_front();
    return command;
}

void Control::carry_out(const Command& c, const std::string& label) {
    const bool alone = c.rest.empty();
    if (c.word == "next") ends_ = alone || c.rest == label;
    else if (c.word == "pause" && alone) paused_ = true;
    else if (c.word == "go" && alone) paused_ = false;
    else base::warn(pipe_->path(), "\"" + base::excerpt(c.word + " " + c.rest) + "\" is not a command");
}

bool Control::ends_picture(const std::string& label) {
    if (!pipe_) return false;
    ends_ = false;
    for (;;) {
        while (!ends_) {
            const std::optional<Command> command = take();
            if (!command) break;
            carry_out(*command, label);
        }
        if (ends_ || !paused_ || base::stop_requested()) return ends_;
        if (base::stdout_is_closed()) throw base::ClosedPipe{};
    }
}

}  // namespace render
