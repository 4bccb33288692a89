// SPDX-License-Identifier: BSD-3-Clause
// See threads.h.
#include "base/threads.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace base {
namespace {

std::vector<std::thread> start(unsigned count, const std::function<void()>& body) {
    std::vector<std::thread> threads;
    threads.reserve(count);
    try {
        while (threads.size() < count) threads.emplace_back(body);
    } catch (const std::exception&) {
        // fewer will do
    }
    return threads;
}

}  // namespace

void on_threads(unsigned count, const std::function<void()>& body) {
    std::exception_ptr first;
    std::mutex lock;
    const auto guarded = [&] {
        try {
            body();
        } catch (...) {
            const std::lock_guard<std::mutex> hold(lock);
            if (!first) first = std::current_exception();
        }
    };
    std::vector<std::thread> threads = start(count > 0 ? count - 1 : 0, guarded);
    guarded();
    for (std::thread& t : threads) t.join();
    if (first) std::rethrow_exception(first);
}

void in_shares(size_t count, size_t share, unsigned threads, const std::function<void(size_t, size_t)>& body) {
    const size_t shares = (count + share - 1) / share;
    std::atomic<size_t> next{0};
    on_threads(unsigned(std::min<size_t>(threads, shares)), [&] {
        try {
            for (size_t k; (k = next.fetch_add(1)) < shares;) body(k * share, std::min(count, (k + 1) * share));
        } catch (...) {
            next = shares;  // the others end, too
            throw;
        }
    });
}

unsigned available_threads(unsigned count) {
    std::mutex gate;  // shut until all have been started
    gate.lock();
    std::vector<std::thread> threads =
        start(count > 0 ? count - 1 : 0, [&] { const std::lock_guard<std::mutex> pass(gate); });
    gate.unlock();
    for (std::thread& t : threads) t.join();
    return unsigned(threads.size()) + 1;
}

}  // namespace base
