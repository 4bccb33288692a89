// SPDX-License-Identifier: BSD-3-Clause
// See control.h.
#include "render/control.h"

#include <algorithm>

#include "base/error.h"
#include "base/run.h"
#include "base/shutdown.h"

namespace render {
namespace {

constexpr int patience_ms = 100;    // longest wait of a thread between two checks
constexpr int look_ms = 10;         // between looks at the files; after two equal ones the editor has finished
constexpr int looks_for_gone = 15;  // for a missing or empty file: editors move it away, or empty it, then write it

bool is_pause(const Command& c) { return c.word == "pause" && c.rest.empty(); }

// Does it ask for nothing but these texts?
bool is_read(const Command& c, const base::Overlays& texts) {
    if (c.word != "overlay") return !c.reads_files();
    const auto text = base::overlay_of(texts, base::stamp_of(c.file()));
    return text && c.text ? *text == *c.text : !text && !c.text;
}

}  // namespace

bool Control::is_edit(const Command& c) const {
    if (c.word == "go" && c.rest.empty()) return preview_;
    return c.word != "next" && c.word != "what" && !is_pause(c);
}

bool Control::is_deaf() const {
    const auto ends = [](const Command& c) { return c.word == "go"; };
    return deaf_until_ > Clock::now() && std::none_of(commands_.begin(), commands_.end(), ends);
}

void Control::set_preview(bool preview, Clock::time_point deaf_until, base::Overlays texts) {
    const std::lock_guard<std::mutex> hold(lock_);
    preview_ = preview;
    deaf_until_ = deaf_until;
    texts_ = std::move(texts);
    look_for_wish();
}

Control::Control(const std::string& fifo, bool watch) : watch_(watch) {
    if (!fifo.empty()) reader_ = std::make_unique<CommandReader>(fifo);
    if (reader_ || watch_) thread_ = std::thread([this] { listen(); });
}

Control::~Control() {
    leaves_ = true;
    if (thread_.joinable()) thread_.join();
}

void Control::send(const Command& command) {
    const std::lock_guard<std::mutex> hold(lock_);
    commands_.push_back(command);
    look_for_wish();
    arrived_.notify_all();
}

// A "next" before an edit applies to the current frame, and a question behind "pause" is answered after it.
void Control::look_for_wish() {
    const auto decides = [this](const Command& c) { return c.word == "next" || is_edit(c); };
    const auto first = std::find_if(commands_.begin(), commands_.end(), decides);
    const size_t pauses = size_t(std::count_if(commands_.begin(), commands_.end(), is_pause));
    using device::Wish;
    const bool edit = first != commands_.end() && is_edit(*first) && !is_deaf();
    const auto reads = [this](const Command& c) { return !is_read(c, texts_); };
    files_wait_ = edit && std::any_of(first, commands_.end(), reads);
    wish_ = edit ? Wish::end : !commands_.empty() && commands_.size() == pauses ? Wish::wait : Wish::go_on;
}

void Control::watch(const base::FilesRead& files) {
    const std::lock_guard<std::mutex> hold(lock_);
    files_ = files;
}

void Control::look_at_files() {
    base::FilesRead files;
    {
        const std::lock_guard<std::mutex> hold(lock_);
        files = files_;
    }
    const base::FilesNow now = base::files_now(files);
    steady_ = now.state == seen_ ? steady_ + 1 : 0;
    seen_ = now.state;
    if (!now.changed || now.state == told_ || steady_ < (now.gone ? looks_for_gone : 1)) return;
    told_ = now.state;
    send({"scene", ""});
}

void Control::listen() {
    const int wait_ms = watch_ ? look_ms : patience_ms;
    while (!leaves_) {
        try {
            while (const auto command = reader_ ? reader_->next() : std::nullopt) send(*command);
        } catch (const base::Error& e) {
            base::warn(e.where, e.message);
        }
        if (watch_) look_at_files();
        if (const std::lock_guard<std::mutex> hold(lock_); deaf_until_ != Clock::time_point()) look_for_wish();
        if (wish_ == device::Wish::wait && (base::shutdown_requested() || base::stdout_is_closed()))
            wish_ = device::Wish::go_on;  // nobody is left to wait for
        if (reader_) reader_->wait(wait_ms);
        else std::this_thread::sleep_for(std::chrono::milliseconds(wait_ms));
    }
}

std::optional<Command> Control::take(bool next_too) {
    std::unique_lock<std::mutex> hold(lock_);
    if (paused_ && commands_.empty() && next_too) arrived_.wait_for(hold, std::chrono::milliseconds(patience_ms));
    if (commands_.empty()) return std::nullopt;
    Command command = commands_.front();
    if (is_edit(command) ? is_deaf() : command.word == "next" && !next_too) return std::nullopt;
    if (edited() && !is_edit(command)) return std::nullopt;  // it applies to the picture after the edit
    commands_.pop_front();
    look_for_wish();
    return command;
}

void Control::carry_out(const Command& c, const std::string& label) {
    if (c.word == "what") return answer_ ? answer_(c.rest) : void();
    if (is_edit(c)) edits_.push_back(c);
    if (c.word == "next") ends_ = c.rest.empty() || c.rest == label;
    else paused_ = !is_edit(c) && c.word == "pause";
}

bool Control::ends_picture(const std::string& label) {
    ends_ = false;
    while (thread_.joinable()) {
        while (!ends_) {
            const std::optional<Command> command = take(true);
            if (!command) break;
            carry_out(*command, label);
        }
        set_preview(preview_);
        if (ends_ || edited() || !paused_ || base::shutdown_requested()) break;
        if (base::stdout_is_closed()) throw base::ClosedPipe{};
    }
    return ends_;
}

std::vector<Command> Control::take_edits() {
    while (const std::optional<Command> command = take(false)) carry_out(*command, "");
    return std::exchange(edits_, {});
}

void Control::wait_for_edit(const std::string& label, bool next_ends) {
    while (!edited() && !base::shutdown_requested()) {
        paused_ = true;  // until an edit
        if (ends_picture(label) && next_ends) break;
    }
    paused_ = false;
}

}  // namespace render
