// SPDX-License-Identifier: BSD-3-Clause
// Starts other programs and waits for them.
#pragma once
#include <sys/types.h>

#include <atomic>
#include <cstddef>
#include <string>
#include <vector>

namespace base {

struct ChildFiles {
    int in = -1;  // -1: an empty standard input
    int out = 1;
    int errors = 2;             // -1: nowhere
    bool ends_with_us = false;  // SIGTERM, if the thread that starts it ends
};

// Starts a program, found along PATH, with the ordinary signals; errno, 0 if it runs.  group: it has a process group of
// its own, whose number stands there before the next signal arrives.
int start_child(const std::vector<std::string>& words, const ChildFiles& files, pid_t& child,
                std::atomic<pid_t>* group = nullptr);
int wait_for_child(pid_t child);  // its exit status; 128 + n: ended by signal n
// Returns all that it writes, or a little more than the limit.
std::string read_to_end(int fd, size_t limit);

}  // namespace base
