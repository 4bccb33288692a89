// SPDX-License-Identifier: BSD-3-Clause
// read(2) and write(2) that go on after a signal, and that wait where the program that gave us the descriptor made it
// non-blocking (a terminal multiplexer, node, ssh).
#pragma once
#include <sys/types.h>

#include <cstddef>

namespace base {

ssize_t read_some(int fd, void* data, size_t bytes);  // as read(2)
// Both, one after the other.  False: errno says why.
bool write_all(int fd, const void* data, size_t bytes, const void* more = nullptr, size_t more_bytes = 0);

}  // namespace base
