// SPDX-License-Identifier: BSD-3-Clause
// See child.h.
#include "live/child.h"

#include <unistd.h>

#include <cerrno>

#include "base/child.h"
#include "base/descriptor.h"
#include "base/error.h"

namespace live {

void End::leave() {
    if (fd >= 0) close(fd);
    fd = -1;
}

Channel::Channel() {
    int ends[2];
    errno = 0;
    if (!base::make_pipe(ends)) base::fail_system("pipe", "cannot be made");
    out.fd = ends[0], in.fd = ends[1];
}

Child::Child(const std::vector<std::string>& command, int errors) {
    errno = base::start_child(command, {in_.out.fd, out_.in.fd, errors, true}, pid_);
    in_.out.leave();
    out_.in.leave();
    if (errno != 0) base::fail_system(command[0], "cannot be started");
}

int Child::wait() { return base::wait_for_child(pid_); }

Outcome run(const std::vector<std::string>& command, const std::string& input, int errors) {
    Outcome out;
    try {
        Child child(command, errors);
        base::write_all(child.input(), input.data(), input.size());
        child.close_input();
        out.text = base::read_to_end(child.output(), size_t(-1) / 2);
        out.status = child.wait();
    } catch (const base::Error&) {
        out.status = int(base::Kind::system);
    }
    return out;
}

}  // namespace live
