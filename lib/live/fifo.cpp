// SPDX-License-Identifier: BSD-3-Clause
// See fifo.h.
#include "live/fifo.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/error.h"

namespace live {

namespace {
constexpr size_t longest_line = 4000;

bool is_fifo(int fd) {
    struct stat info = {};
    return fstat(fd, &info) == 0 && S_ISFIFO(info.st_mode);
}
}  // namespace

Written write_whole(const std::string& fifo, const std::string& bytes) {
    const int fd = open(fifo.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
    if (fd < 0) return Written::nobody;
    Written result = Written::nobody;
    if (is_fifo(fd)) {
        int room = fcntl(fd, F_GETPIPE_SZ), unread = 0;
        if (room < int(bytes.size())) room = fcntl(fd, F_SETPIPE_SZ, int(2 * bytes.size()));
        // a page of the pipe may be partly used: the last 4 kB do not count
        const bool fits = ioctl(fd, FIONREAD, &unread) == 0 &&
                          (unread == 0 ? int(bytes.size()) <= room : unread + int(bytes.size()) + 8192 <= room);
        result =
            fits && write(fd, bytes.data(), bytes.size()) == ssize_t(bytes.size()) ? Written::whole : Written::busy;
    }
    close(fd);
    return result;
}

// Opened for both ways: it is there before its writers and does not end with them.
FifoLines::FifoLines(const std::string& fifo) {
    errno = 0;
    fd_ = open(fifo.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
    if (fd_ < 0) base::fail_system(fifo, "cannot be opened");
}

FifoLines::~FifoLines() { close(fd_); }

std::vector<std::string> FifoLines::read() {
    std::vector<std::string> lines;
    char block[4096];
    for (ssize_t n; (n = ::read(fd_, block, sizeof block)) > 0;)
        for (const char* c = block; c != block + n; ++c) {
            if (*c == '\n') lines.push_back(std::move(rest_)), rest_.clear();
            else if (rest_.size() < longest_line) rest_ += *c;
        }
    return lines;
}

}  // namespace live
