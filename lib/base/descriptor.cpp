// SPDX-License-Identifier: BSD-3-Clause
// See descriptor.h.
#include "base/descriptor.h"

#include <poll.h>
#include <sys/uio.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>

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

}  // namespace

ssize_t read_some(int fd, void* data, size_t bytes) {
    for (;;) {
        errno = 0;
        const ssize_t n = ::read(fd, data, bytes);
        if (n >= 0 || !again(fd, POLLIN)) return n;
    }
}

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

}  // namespace base
