// SPDX-License-Identifier: BSD-3-Clause
// See messages.h.
#include "live/messages.h"

#include <fcntl.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"
#include "live/programs.h"

namespace live {

namespace {
const std::string our_last_line = "\4";
}

// Opened for both ways: it is there before its writers and does not end with them.
Messages::Messages(const std::string& fifo, Live& live) : fifo_((errno = 0, open(fifo.c_str(), O_RDWR | O_CLOEXEC))) {
    if (fifo_.fd < 0) base::fail_system(fifo, "cannot be opened");
    thread_ = std::thread([this, &live] {
        read_lines(fifo_.fd, [&](const std::string& line) {
            if (line == our_last_line) return false;
            return live.put_said(Which::picture, line), true;
        });
    });
}

Messages::~Messages() {
    const std::string end = "\n" + our_last_line + "\n";
    base::write_all(fifo_.fd, end.data(), end.size());
    thread_.join();
}

}  // namespace live
