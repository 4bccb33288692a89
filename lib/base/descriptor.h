// SPDX-License-Identifier: BSD-3-Clause
// Files, pipes and terminals by their descriptors.  Calls go on after a signal, and wait where the program that gave us
// the descriptor made it non-blocking (a terminal multiplexer, node, ssh).  Where one fails, errno says why.
#pragma once
#include <sys/types.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace base {

// -1: it failed.  waits: a FIFO for its writer.
int open_to_read(const std::string& path, bool waits);
int open_nameless(const std::string& text);  // at the beginning of a file that holds this text and has no name
void close_descriptor(int fd);               // errno stays

ssize_t read_some(int fd, void* data, size_t bytes);                // as read(2)
ssize_t read_at(int fd, void* data, size_t bytes, uint64_t place);  // as pread(2)
uint64_t place_in(int fd);                                          // of an ordinary file: where read_some() reads next
// Both, one after the other.
bool write_all(int fd, const void* data, size_t bytes, const void* more = nullptr, size_t more_bytes = 0);

bool is_terminal(int fd);
bool make_pipe(int ends[2]);  // one to read, one to write; children inherit neither
void widen_pipe(int fd);      // fewer switches between two programs; a wish only
bool has_no_reader(int pipe);
bool append_to(int fd, const std::string& path);  // what fd gets from now on is appended to this file
void lead_nowhere(int fd);  // what is written is lost, and the reader of the pipe gets its end at once

}  // namespace base
