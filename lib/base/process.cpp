// SPDX-License-Identifier: BSD-3-Clause
// See process.h.
#include "base/process.h"

#include <pthread.h>
#include <sys/resource.h>

#include <filesystem>

namespace base {
namespace {

void* call(void* body) {
    (*static_cast<const std::function<void()>*>(body))();
    return nullptr;
}

}  // namespace

void ready_standard_files() {}

void with_enough_stack(const std::function<void()>& body) {
    struct rlimit limit = {};
    if (getrlimit(RLIMIT_STACK, &limit) != 0 || limit.rlim_cur >= enough_stack) return body();
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, enough_stack);
    pthread_t thread;
    const bool started = pthread_create(&thread, &attributes, call, const_cast<std::function<void()>*>(&body)) == 0;
    pthread_attr_destroy(&attributes);
    if (started) pthread_join(thread, nullptr);
    else body();
}

std::vector<std::string> typed_words(int argc, char** argv) { return {argv, argv + argc}; }

std::string program_file() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

}  // namespace base
