// SPDX-License-Identifier: BSD-3-Clause
// Programs in a pipe, started, fed, watched and ended: what every campaign of tests/break does to the tools.
#pragma once
#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace breaking {

struct Stage {
    std::vector<std::string> words;     // the program's path and its arguments
    std::function<bool()> before = {};  // in the child, just before exec; false: this fault cannot be had here
};

struct Job {
    std::vector<Stage> stages;
    std::string input;                                              // given to the first stage by a pipe
    std::string folder;                                             // working folder of all stages
    std::vector<std::string> environment;                           // NAME=value, instead of ours
    double limit_s = 30;                                            // then all are killed: a hang
    std::function<void(const std::vector<pid_t>&)> meanwhile = {};  // once all run
};

struct Ended {
    std::string tool;             // ptrace, ptaccum ...
    int status = -1, signal = 0;  // one of the two
    bool hung = false, unavailable = false;
    bool behind_error = false;  // a program before it in the pipe failed, and has said why
    std::string talk;           // stderr
};

struct Result {
    std::vector<Ended> stages;
    std::string out;             // of the last stage
    bool left_children = false;  // something of the process group lived on
    bool hung() const;
    bool unavailable() const;
    std::string describe() const;  // statuses and talk, for a report
};

Result run(const Job& job);

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool bears_little_memory = false;  // a sanitizer maps terabytes
#else
constexpr bool bears_little_memory = true;
#endif

// Faults for Stage::before; false where they cannot be had.
bool limit_memory(size_t megabytes);

// What is wrong with how a program ended, whatever it was asked: a signal, a sanitizer's report, a hang, a status that
// no manual page knows, an error that is not one plain line "tool: place: fact" (behind an error, one line or none).
// Empty: nothing.
std::string complaint(const Ended& ended);
std::string complaint(const Result& result);  // of all stages

}  // namespace breaking
