// SPDX-License-Identifier: BSD-3-Clause
// A thread that does its work each time it is asked to; it ends with the value, after the work at hand.
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>
#include "base/wait.h"

namespace live {

class Worker {
public:
    explicit Worker(std::function<void()> work) : work_(std::move(work)), thread_([this] { run(); }) {}
    ~Worker() {
        set(ends_);
        thread_.join();
    }
    Worker(const Worker&) = delete;
    void ask() { set(wanted_); }

private:
    void set(bool& what) {
        const std::lock_guard<std::mutex> lock(mutex_);
        what = true;
        asked_.notify_all();
    }
    void run() {
        for (std::unique_lock<std::mutex> lock(mutex_);;) {
            base::wait(asked_, lock, [this] { return wanted_ || ends_; });
            if (ends_) return;
            wanted_ = false;
            lock.unlock();
            work_();
            lock.lock();
        }
    }
    const std::function<void()> work_;
    std::mutex mutex_;
    std::condition_variable asked_;
    bool wanted_ = false, ends_ = false;
    std::thread thread_;
};

}  // namespace live
