// SPDX-License-Identifier: BSD-3-Clause
// See stack.h.
#include "base/stack.h"

#include <pthread.h>
#include <sys/resource.h>

namespace base {
namespace {

// The usual default of systems, for which the limits of lib/cal are made.
constexpr size_t enough = size_t(8) << 20;

void* call(void* body) {
    (*static_cast<const std::function<void()>*>(body))();
    return nullptr;
}

}  // namespace

void with_enough_stack(const std::function<void()>& body) {
    struct rlimit limit = {};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= enough) return body();
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, enough);
    pthread_t thread;
    const bool started = pthread_create(&thread, &attributes, call, const_cast<std::function<void()>*>(&body)) == 0;
    pthread_attr_destroy(&attributes);
    if (started) pthread_join(thread, nullptr);
    else body();
}

}  // namespace base
