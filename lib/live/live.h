// SPDX-License-Identifier: BSD-3-Clause
// The loop around step(): it holds the state, hands it what happens, one after the other, and carries out what is to be
// done.  Called by the threads that pass bytes on and by the web server; all functions may be called from any thread.
#pragma once
#include <chrono>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <vector>
#include "live/step.h"

namespace live {

class Live {
public:
    explicit Live(Files files = {});
    Live(const Live&) = delete;
    void on_change(std::function<void()> changed) { changed_ = std::move(changed); }  // called without the lock
    // Carries out ToPipe and Start, with the lock.
    void on_effect(std::function<void(const Effect&)> carry) {
        const std::lock_guard<std::mutex> lock(mutex_);
        carry_ = std::move(carry);
    }
    void set_against(std::string file) { against_ = std::move(file); }  // vcmetrics reads it

    // Before anything else happens: what was known before.
    template <class CHANGE>
    void begin(CHANGE&& how) {
        how(state_);
    }
    Answer ask(const Request& request);
    void put(decltype(Event::what) what);
    void put_picture(Which which, image::Picture picture);
    std::string put_line(Which which, std::string line);  // of vcmetrics; with the number that its edit has here
    void put_said(Which which, const std::string& line);  // what is news goes to our own standard error, too
    void put_end(int status);                             // the pipe has ended with this status
    bool look_at_files();                                 // other programs may have written them.  True: one is another

    struct Numbers {
        size_t picture = 0, line = 0, files = 0, design = 0;
    };
    struct News : Numbers {                           // of the newest
        std::shared_ptr<const image::Picture> shown;  // if newer than the one asked about
        std::vector<std::string> lines;               // those after the one asked about
        std::string state;                            // as JSON, if newer than the one asked about
        std::optional<int> ended;
    };
    // Nothing: there is no news since these.
    std::optional<News> since(Numbers known, bool knows_end) const;
    Numbers numbers() const;  // of the newest
    State state() const;
    const Files& files() const { return files_; }

private:
    std::optional<Answer> happen(const Event& event);
    void look_at(size_t n);
    double now() const;
    mutable std::mutex mutex_;
    std::function<void()> changed_;
    std::function<void(const Effect&)> carry_;
    std::string against_;
    Files files_;
    State state_;
    std::string shown_;  // of the state, as JSON
    size_t pictures_ = 0, file_changes_ = 0, designs_ = 0;
    std::vector<std::string> lines_, names_[3];  // names_: of the columns of each pipe
    const std::chrono::steady_clock::time_point since_ = std::chrono::steady_clock::now();
};

}  // namespace live
