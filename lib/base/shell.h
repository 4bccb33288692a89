// SPDX-License-Identifier: BSD-3-Clause
// A command line run by /bin/sh (-exec), and what it writes.  It starts with the ordinary signals, an empty standard
// input and a process group of its own, which a signal to the tool ends.
#pragma once
#include <cstddef>
#include <string>

namespace base {

struct ShellOutput {
    std::string text;
    int status = 0;         // of the shell; 128 + n: ended by signal n
    bool too_long = false;  // it wrote more than the limit and was ended
};
ShellOutput run_shell(const std::string& command, size_t limit, const std::string& place);

// For a signal handler: ends the command that runs now, and all it started.
void end_shell();

}  // namespace base
