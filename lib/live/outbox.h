// SPDX-License-Identifier: BSD-3-Clause
// Bytes for a program, written in the order in which they are given, without letting the giver wait: by a thread, to
// the end of a pipe or to a FIFO.
#pragma once
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include "live/child.h"

namespace live {

class Outbox {
public:
    Outbox() : thread_([this] { work(); }) {}
    ~Outbox();
    Outbox(const Outbox&) = delete;
    void to(int descriptor);                // which it closes; -1: to nobody, what waits neither
    bool listens(const std::string& fifo);  // somebody reads it, who gets what follows
    void put(const std::string& bytes);
    bool is_full() const;

private:
    void work();
    mutable std::mutex mutex_;
    std::condition_variable news_;
    std::shared_ptr<const End> end_;
    std::string waiting_;
    bool ends_ = false;
    std::thread thread_;
};

}  // namespace live
