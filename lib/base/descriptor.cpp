// SPDX-License-Identifier: BSD-3-Clause
// See descriptor.h.
#include "base/descriptor.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>

namespace base {
namespace {

// True if the call is worth another try: after a signal, or once a non-blocking descriptor is ready.
bool again(int fd, short event) {
    if (errno == EINTR) return true;
    if (errno != EAGAIN && errno != EWOULDBLOCK) return false;
    struct pollfd wait = {fd, event, 0};
    poll(&wait, 1, -1);
    return true;
}

// Makes fd write to the file of this path; opened first, so that stderr still works where that fails.
bool redirect(int fd, const char* path, int flags) {
    errno = 0;
    const int there = open(path, O_WRONLY | O_CLOEXEC | flags, 0666);
    const bool done = there >= 0 && dup2(there, fd) >= 0;
    if (there >= 0) close_descriptor(there);
    return done;
}

}  // namespace

int open_to_read(const std::string& path, bool waits) {
    return open(path.c_str(), O_RDONLY | O_CLOEXEC | (waits ? 0 : O_NONBLOCK | O_NOCTTY));
}

int open_nameless(const std::string& text) {
    FILE* file = std::tmpfile();
    if (!file) return -1;
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
    std::rewind(file);
    const int fd = written ? fcntl(fileno(file), F_DUPFD_CLOEXEC, 0) : -1, code = errno;
    std::fclose(file);
    errno = code;
    return fd;
}

void close_descriptor(int fd) {
    const int code = errno;
    close(fd);
    errno = code;
}

ssize_t read_some(int fd, void* data, size_t bytes) {
    for (;;) {
        errno = 0;
        const ssize_t n = ::read(fd, data, bytes);
        if (n >= 0 || !again(fd, POLLIN)) return n;
    }
}

ssize_t read_at(int fd, void* data, size_t bytes, uint64_t place) {
    for (;;) {
        errno = 0;
        const ssize_t n = ::pread(fd, data, bytes, off_t(place));
        if (n >= 0 || errno != EINTR) return n;
    }
}

uint64_t place_in(int fd) { return uint64_t(lseek(fd, 0, SEEK_CUR)); }

bool write_all(int fd, const void* data, size_t bytes, const void* more, size_t more_bytes) {
    struct iovec parts[2] = {{const_cast<void*>(data), bytes}, {const_cast<void*>(more), more_bytes}};
    for (int at = 0; at < 2;) {
        if (parts[at].iov_len == 0) {
            ++at;
            continue;
        }
        errno = 0;
        const ssize_t n = ::writev(fd, parts + at, 2 - at);
        if (n < 0 && !again(fd, POLLOUT)) return false;
        size_t written = n > 0 ? size_t(n) : 0;
        for (int k = at; k < 2 && written > 0; ++k) {
            const size_t of_it = std::min(written, parts[k].iov_len);
            parts[k].iov_base = static_cast<char*>(parts[k].iov_base) + of_it;
            parts[k].iov_len -= of_it, written -= of_it;
        }
    }
    return true;
}

bool is_terminal(int fd) { return isatty(fd); }

bool make_pipe(int ends[2]) {
#ifdef __linux__
    return pipe2(ends, O_CLOEXEC) == 0;
#else
    if (pipe(ends) != 0) return false;
    for (int k = 0; k < 2; ++k) fcntl(ends[k], F_SETFD, FD_CLOEXEC);
    return true;
#endif
}

void widen_pipe(int fd) {
#ifdef F_SETPIPE_SZ
    fcntl(fd, F_SETPIPE_SZ, 1 << 20);
#else
    (void)fd;
#endif
}

bool has_no_reader(int pipe) {
    struct pollfd out = {pipe, 0, 0};
    return poll(&out, 1, 0) > 0 && (out.revents & POLLERR);
}

bool append_to(int fd, const std::string& path) { return redirect(fd, path.c_str(), O_CREAT | O_APPEND); }
void lead_nowhere(int fd) { redirect(fd, "/dev/null", 0); }

}  // namespace base
