// SPDX-License-Identifier: BSD-3-Clause
// A machine that gives few threads: preloaded into a program, it lets pthread_create() succeed as often as
// LUXPIPE_TEST_THREADS says.
#include <cerrno>
#include <cstdlib>
#include <dlfcn.h>
#include <pthread.h>

#include <atomic>

using Run = void* (*)(void*);

extern "C" int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, Run run, void* argument) {
    using Create = int (*)(pthread_t*, const pthread_attr_t*, Run, void*);
    static const Create real = reinterpret_cast<Create>(dlsym(RTLD_NEXT, "pthread_create"));
    const char* allowed = std::getenv("LUXPIPE_TEST_THREADS");
    static std::atomic<int> left{allowed ? std::atoi(allowed) : 0};
    return left-- > 0 ? real(thread, attributes, run, argument) : EAGAIN;
}
