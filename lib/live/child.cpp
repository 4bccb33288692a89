// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "live/child.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>

#include "base/child.h"
#include "base/descriptor.h"
#include "base/error.h"

namespace live {

Child::Child(const std::vector<std::string>& command, int errors) {
    int in[2], out[2];
    errno = 0;
    if (pipe2(in, O_CLOEXEC) != 0 || pipe2(out, O_CLOEXEC) != 0) base::fail_system("pipe", "cannot be made");
    errno = base::start_child(command, {in[0], out[1], errors, true}, pid_);
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

Outcome run(const std::vector<std::string>& command, const std::string& input, int errors) {
    Outcome out;
    try {
        Child child(command, errors);
        base::write_all(child.input(), input.data(), input.size());
        child.close_input();
        char block[1 << 14];
        for (ssize_t n; (n = base::read_some(child.output(), block, sizeof block)) > 0;)
            out.text.append(block, size_t(n));
        out.status = child.wait();
    } catch (const base::Error&) {
        out.status = int(base::Kind::system);
    }
    return out;
}

}  // namespace live
