// SPDX-License-Identifier: BSD-3-Clause
// See control.h.
#include "render/control.h"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>

#include "base/error.h"
#include "base/files_read.h"
#include "base/number.h"
#include "base/printable.h"
#include "base/run.h"
#include "base/shutdown.h"

namespace render {
namespace {

constexpr int patience_ms = 100;  // longest wait of a thread between two checks
constexpr int look_ms = 25;       // between looks at the files; after two equal ones the editor has finished
constexpr int patience_for_text_s = 10;
constexpr long most_bytes = 1 << 26;
constexpr int looks_for_gone = 6;  // for a missing file: editors move it away before they write it anew

// Splits "  next desk " into next and desk.
Command parse(const std::string& line) {
    const char* blanks = " \t\r";
    const size_t from = line.find_first_not_of(blanks);
    if (from == std::string::npos) return {};
    const size_t end = line.find_first_of(blanks, from), rest = line.find_first_not_of(blanks, end);
    if (rest == std::string::npos) return {line.substr(from, end - from), ""};
    return {line.substr(from, end - from), line.substr(rest, line.find_last_not_of(blanks) + 1 - rest)};
}

// BYTES of "overlay FILE BYTES", whose FILE becomes the rest; -1: another line.
long bytes_of_overlay(Command& c) {
    const size_t blank = c.rest.find_last_of(" \t");
    long long bytes;
    if (c.word != "overlay" || blank == std::string::npos) return -1;
    if (!base::parse_integer(c.rest.substr(blank + 1), bytes) || bytes < 0 || bytes > most_bytes) return -1;
    c.rest.erase(c.rest.find_last_not_of(" \t", blank) + 1);
    return long(bytes);
}

}  // namespace

bool Control::is_edit(const Command& c) const {
    if (c.word == "go" && c.rest.empty()) return preview_;
    return c.word != "next" && !(c.word == "pause" && c.rest.empty());
}

void Control::set_preview(bool preview) {
    const std::lock_guard<std::mutex> hold(lock_);
    preview_ = preview;
    look_for_edits();
}

Control::Control(const std::string& fifo, bool watch) : watch_(watch) {
    if (!fifo.empty()) pipe_ = std::make_unique<base::CommandPipe>(fifo);
    if (pipe_ || watch_) thread_ = std::thread([this] { listen(); });
}

Control::~Control() {
    leaves_ = true;
    if (thread_.joinable()) thread_.join();
}

void Control::send(const Command& command) {
    const std::lock_guard<std::mutex> hold(lock_);
    commands_.push_back(command);
    look_for_edits();
    arrived_.notify_all();
}

// A "next" before an edit applies to the current frame.
void Control::look_for_edits() {
    const auto decides = [this](const Command& c) { return c.word == "next" || is_edit(c); };
    const auto first = std::find_if(commands_.begin(), commands_.end(), decides);
    edit_waits_ = first != commands_.end() && is_edit(*first);
}

void Control::look_at_files() {
    const base::FilesNow now = base::files_now();
    steady_ = now.state == seen_ ? steady_ + 1 : 0;
    seen_ = now.state;
    if (!now.changed || now.state == told_ || steady_ < (now.gone ? looks_for_gone : 1)) return;
    told_ = now.state;
    send({"scene", ""});
}

// The next command that has arrived completely.
std::optional<Command> Control::arrived() {
    using Clock = std::chrono::steady_clock;
    while (!overlay_) {
        const std::optional<std::string> line = pipe_->line();
        if (!line) return std::nullopt;
        Command command = parse(*line);
        if (command.word.empty()) continue;
        overlay_bytes_ = bytes_of_overlay(command);
        if (overlay_bytes_ < 0) return command;
        overlay_ = std::move(command);
        overlay_since_ = Clock::now();
    }
    overlay_->text = pipe_->bytes(size_t(overlay_bytes_));
    if (overlay_->text) return std::exchange(overlay_, std::nullopt);
    if (Clock::now() - overlay_since_ < std::chrono::seconds(patience_for_text_s)) return std::nullopt;
    const std::string file = std::exchange(overlay_, std::nullopt)->rest;
    base::fail(pipe_->path(), fmt::format("the {} bytes for {} did not arrive", overlay_bytes_, base::excerpt(file)));
}

void Control::listen() {
    const int wait_ms = watch_ ? look_ms : patience_ms;
    while (!leaves_) {
        try {
            while (const auto command = pipe_ ? arrived() : std::nullopt) send(*command);
        } catch (const base::Error& e) {
            base::warn(e.where, e.message);
        }
        if (watch_) look_at_files();
        if (pipe_) pipe_->wait(wait_ms);
        else std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    }
}

std::optional<Command> Control::take() {
    std::unique_lock<std::mutex> hold(lock_);
    if (paused_ && commands_.empty()) arrived_.wait_for(hold, std::chrono::milliseconds(patience_ms));
    if (commands_.empty()) return std::nullopt;
    if (edited() && !is_edit(commands_.front())) return std::nullopt;  // it applies to the picture after the edit
    Command command = commands_.front();
    commands_.pop_front();
    look_for_edits();
    return command;
}

void Control::carry_out(const Command& c, const std::string& label) {
    if (is_edit(c)) edits_.push_back(c);
    if (c.word == "next") ends_ = c.rest.empty() || c.rest == label;
    else paused_ = !is_edit(c) && c.word == "pause";
}

bool Control::ends_picture(const std::string& label) {
    ends_ = false;
    while (thread_.joinable()) {
        while (!ends_) {
            const std::optional<Command> command = take();
            if (!command) break;
            carry_out(*command, label);
        }
        if (ends_ || edited() || !paused_ || base::shutdown_requested()) break;
        if (base::stdout_is_closed()) throw base::ClosedPipe{};
    }
    return ends_;
}

void Control::wait_for_edit(const std::string& label, bool next_ends) {
    while (!edited() && !base::shutdown_requested()) {
        paused_ = true;  // until an edit
        if (ends_picture(label) && next_ends) break;
    }
    paused_ = false;
}

}  // namespace render
