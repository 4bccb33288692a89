// SPDX-License-Identifier: BSD-3-Clause
// A program whose standard input and output are ours, such as the one after "--", which reads what vcview reads.
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

namespace live {

// A descriptor that is ours.
struct End {
    int fd;
    explicit End(int d = -1) : fd(d) {}
    ~End() { leave(); }
    End(const End&) = delete;
    void leave();
};

// A pipe: read from `out`, write to `in`.
struct Channel {
    End out, in;
    Channel();  // throws base::Error (system)
};

class Child {
public:
    // errors: its standard error; -1: nobody's.  Throws base::Error (system) if there is no such program.
    explicit Child(const std::vector<std::string>& command, int errors = 2);
    int input() const { return in_.in.fd; }     // write to it
    int output() const { return out_.out.fd; }  // read from it
    void close_input() { in_.in.leave(); }
    int wait();  // its exit status, 128 + signal if one ended it

private:
    pid_t pid_ = -1;
    Channel in_, out_;
};

// A program that reads this input to its end.
struct Outcome {
    int status = 0;    // 2 where it cannot be started
    std::string text;  // its standard output
};
Outcome run(const std::vector<std::string>& command, const std::string& input, int errors);

}  // namespace live
