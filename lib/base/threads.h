// SPDX-License-Identifier: BSD-3-Clause
// Work on several threads, on fewer where the system gives no more (a limit of processes, no memory for a stack).
#pragma once
#include <cstddef>
#include <functional>
#include "base/processors.h"

namespace base {

// Calls body on up to `count` threads at once, the caller's among them, and returns when all have ended.  A body takes
// its share from a common counter, so that it does not matter how many there are.  Rethrows the first exception of a
// body.
void on_threads(unsigned count, const std::function<void()>& body);

// Calls body(first, end) for shares of 0 .. count - 1, each `share` long but the last, on up to `threads` threads.  No
// share begins after an exception, which is rethrown.
void in_shares(size_t count, size_t share, unsigned threads, const std::function<void(size_t, size_t)>& body);

// Calls body(i) for each i = 0 .. count - 1, on all processors.
template <class F>
void on_all(size_t count, F&& body) {
    in_shares(count, 1, processors(), [&](size_t i, size_t) { body(i); });
}

// Number of threads, of `count` with the caller's, that the system can start: for libraries that fail if they get
// fewer than they asked for.
unsigned available_threads(unsigned count);

}  // namespace base
