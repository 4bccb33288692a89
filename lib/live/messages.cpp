// SPDX-License-Identifier: BSD-3-Clause
// See messages.h.
#include "live/messages.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/split.h"

namespace live {

constexpr size_t longest_line = 4000;

// Opened for both ways: it is there before its writers and does not end with them.
Messages::Messages(const std::string& fifo, Live& live) : live_(live) {
    errno = 0;
    fd_ = open(fifo.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (fd_ < 0) base::fail_system(fifo, "cannot be opened");
    thread_ = std::thread([this] { listen(); });
}

Messages::~Messages() {
    ends_ = true;
    thread_.join();
    pass_on();
    take_line();
    close(fd_);
}

void Messages::listen() {
    while (!ends_) {
        pollfd one{fd_, POLLIN, 0};
        if (poll(&one, 1, 200) > 0) pass_on();
    }
}

void Messages::pass_on() {
    char block[4096];
    for (ssize_t n; (n = ::read(fd_, block, sizeof block)) > 0;) {
        for (const char* c = block; c != block + n; ++c) {
            if (*c != '\n') line_ += *c;
            else take_line();
            if (line_.size() > longest_line) line_.resize(longest_line);
        }
    }
}

void Messages::take_line() {
    if (base::begins_with(line_, "ptrace: what ")) {
        live_.put_seen(line_);
    } else if (!line_.empty()) {
        const std::string line = line_ + "\n";
        base::write_all(2, line.data(), line.size());
        live_.change([&](Design& d) { d.tell(line_); });
    }
    line_.clear();
}

}  // namespace live
