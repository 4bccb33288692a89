// SPDX-License-Identifier: BSD-3-Clause
// See descriptor.h.
#include "base/descriptor.h"

#include <poll.h>
#include <unistd.h>

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

bool write_all(int fd, const void* data, size_t bytes) {
    const char* from = static_cast<const char*>(data);
    while (bytes > 0) {
        errno = 0;
        const ssize_t n = ::write(fd, from, bytes);
        if (n < 0 && !again(fd, POLLOUT)) return false;
        if (n > 0) from += n, bytes -= size_t(n);
    }
    return true;
}

}  // namespace base
