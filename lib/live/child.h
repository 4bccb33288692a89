// SPDX-License-Identifier: BSD-3-Clause
// The program after "--": it reads what vcview reads, and its output goes where vcview's goes.
#pragma once
#include <sys/types.h>

#include <string>
#include <vector>

namespace live {

class Child {
public:
    // errors: its standard error; -1: nobody's.  Throws base::Error (system) if there is no such program.
    explicit Child(const std::vector<std::string>& command, int errors = 2);
    ~Child();
    Child(const Child&) = delete;
    Child& operator=(const Child&) = delete;
    int input() const { return input_; }    // write to it
    int output() const { return output_; }  // read from it
    void close_input();
    int wait();  // its exit status, 128 + signal if one ended it

private:
    pid_t pid_ = -1;
    int input_ = -1, output_ = -1;
};

// A program that reads this input to its end.
struct Outcome {
    int status = 0;    // 2 where it cannot be started
    std::string text;  // its standard output
};
Outcome run(const std::vector<std::string>& command, const std::string& input, int errors);

}  // namespace live
