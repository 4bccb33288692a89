// SPDX-License-Identifier: BSD-3-Clause
// run() wraps main(): it alone catches, prints "tool: place: fact" on stderr and gives the exit status:
// 0 fine, 1 input, 2 system, 3 signal (shutdown.h).  A closed stdout (EPIPE) ends quietly with 0; any other write
// error on stdout (/dev/full) is a system error.
#pragma once
#include <functional>
#include <string>
#include <vector>

namespace base {

int run(const char* tool, const std::function<int()>& body);

// Thrown by writers that meet EPIPE on stdout; run() turns it into status 0 without a message.
struct ClosedPipe {};

// Write all bytes to stdout, or throw ClosedPipe / Error (system).  flush_stdout() likewise.
void write_stdout(const void* data, size_t bytes);
void flush_stdout();
bool stdout_is_terminal();  // no binary to a terminal
bool stdin_is_terminal();
// A line on stderr; on a terminal in the place of a line of progress, which may be another program's.
void say(const std::string& text);
void say_on_terminal(const std::string& text);  // if stderr is a terminal
bool stdout_is_file();                          // what is written is kept under a name
bool stdout_is_closed();                        // the reader of the pipe has gone: for tools that write seldom
void leave_stdout();                            // nothing will be written: the reader of the pipe gets its end at once

// "a b 'c d'": the command line as one header line, quoted for the shell where needed.
std::string command_line(const std::vector<std::string>& words);

}  // namespace base
