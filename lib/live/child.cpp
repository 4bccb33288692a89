// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "live/child.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "base/child.h"
#include "base/error.h"

namespace live {

Child::Child(const std::vector<std::string>& command, int errors) {
    int in[2], out[2];
    errno = 0;
    if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) base::fail_system("pipe", "cannot be made");
    errno = base::start_child(command, {in[0], out[1], errors}, pid_);
    close(in[0]);
    close(out[1]);
    input_ = in[1];
    output_ = out[0];
    if (errno != 0) base::fail_system(command[0], "cannot be started");
}

Child::~Child() {
    close_input();
    if (output_ >= 0) close(output_);
}

void Child::close_input() {
    if (input_ >= 0) close(input_);
    input_ = -1;
}

int Child::wait() { return base::wait_for_child(pid_); }

}  // namespace live
