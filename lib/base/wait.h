// SPDX-License-Identifier: BSD-3-Clause
// Waits until ready(), as change.wait(lock, ready) does, whose symbol (GLIBCXX_3.4.30, of gcc 12) RHEL 9 does not have.
#pragma once
#include <chrono>
#include <condition_variable>
#include <mutex>

namespace base {

template <class Ready>
void wait(std::condition_variable& change, std::unique_lock<std::mutex>& lock, Ready ready) {
    while (!change.wait_for(lock, std::chrono::hours(1), ready)) {}
}

}  // namespace base
