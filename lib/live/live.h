// SPDX-License-Identifier: BSD-3-Clause
// The newest picture and the lines of the metrics, for the page, each numbered from 1, and the design.  Written by the
// threads that pass the bytes on, read by the web server; all functions may be called from any thread.
#pragma once
#include <chrono>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>
#include "image/picture.h"
#include "live/design.h"

namespace live {

class Live {
public:
    // Called after each change, without the lock.
    explicit Live(std::function<void()> changed = {}) : changed_(std::move(changed)) {}
    void on_change(std::function<void()> changed) { changed_ = std::move(changed); }

    void put_picture(image::Picture picture);
    void put_line(std::string line);
    void put_end(int status);                // the pipe has ended with this status
    void put_file_change();                  // a file that the page shows is not what it was
    void put_seen(const std::string& line);  // ptrace's answer to "what"
    // That answer, if it is of the newest picture's edit.
    std::optional<std::string> seen(const std::string& words) const;
    bool asks(const std::string& words);  // the question is to be put (again)

    // Changes the design; the page gets its new state.
    template <class CHANGE>
    void change(CHANGE&& how) {
        put([&] { how(design_), ++designs_; });
    }
    template <class QUESTION>
    auto ask(QUESTION&& what) const {
        const std::lock_guard<std::mutex> lock(mutex_);
        return what(design_);
    }

    struct Numbers {
        size_t picture = 0, line = 0, files = 0, design = 0;
    };
    struct News : Numbers {                           // of the newest
        std::shared_ptr<const image::Picture> shown;  // if newer than the one asked about
        std::vector<std::string> lines;               // those after the one asked about
        std::string state;                            // of the design, as JSON, if newer than the one asked about
        std::optional<int> ended;
    };
    // Nothing: there is no news since these.
    std::optional<News> since(Numbers known, bool knows_end) const;
    std::shared_ptr<const image::Picture> picture() const;
    Numbers numbers() const;  // of the newest

private:
    template <class WRITE>
    void put(WRITE&& write) {
        {
            const std::lock_guard<std::mutex> lock(mutex_);
            write();
        }
        if (changed_) changed_();
    }
    mutable std::mutex mutex_;
    std::function<void()> changed_;
    std::shared_ptr<const image::Picture> picture_;
    size_t pictures_ = 0, file_changes_ = 0, designs_ = 0;
    std::vector<std::string> lines_;
    Design design_;
    struct Question {
        std::chrono::steady_clock::time_point asked;
        std::string answer;  // the number of the edit and what is there; empty: none yet
    };
    std::map<std::string, Question> questions_;  // to ptrace, about the newest picture
    std::optional<int> ended_;
};

}  // namespace live
