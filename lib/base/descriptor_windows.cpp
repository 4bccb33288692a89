// SPDX-License-Identifier: BSD-3-Clause
// See descriptor.h.
#include "base/descriptor.h"

#include <fcntl.h>
#include <io.h>
#include <share.h>
#include <sys/stat.h>
#include <windows.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>

#include "base/new_file.h"

namespace base {
namespace {

constexpr size_t most_at_once = 1 << 24;  // _read() and _write() count in int

HANDLE handle_of(int fd) { return reinterpret_cast<HANDLE>(_get_osfhandle(fd)); }

bool write_part(int fd, const void* data, size_t bytes) {
    for (auto* at = static_cast<const char*>(data); bytes > 0;) {
        errno = 0;
        const int n = _write(fd, at, unsigned(std::min(bytes, most_at_once)));
        if (n < 0) {
            const DWORD why = _doserrno;
            const bool left = why == ERROR_BROKEN_PIPE || why == ERROR_NO_DATA || why == ERROR_PIPE_NOT_CONNECTED;
            if (left) errno = EPIPE;  // not every version says so itself
            return false;
        }
        at += n, bytes -= size_t(n);
    }
    return true;
}

// Makes fd write to the file of this path; opened first, so that stderr still works where that fails.
bool redirect(int fd, const char* path, int flags) {
    errno = 0;
    const int there = _open(path, _O_WRONLY | _O_BINARY | _O_NOINHERIT | flags, _S_IREAD | _S_IWRITE);
    const bool done = there >= 0 && _dup2(there, fd) == 0;
    if (there >= 0) close_descriptor(there);
    return done;
}

}  // namespace

// A file that is open may be replaced by others.
int open_to_read(const std::string& path, bool) {
    const DWORD anyone = FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE;
    const HANDLE file = CreateFileA(path.c_str(), GENERIC_READ, anyone, nullptr, OPEN_EXISTING, 0, nullptr);
    if (file == INVALID_HANDLE_VALUE) return _open(path.c_str(), _O_RDONLY | _O_BINARY | _O_NOINHERIT);  // says why
    return _open_osfhandle(intptr_t(file), _O_RDONLY | _O_BINARY | _O_NOINHERIT);
}

int open_nameless(const std::string& text) {
    char folder[MAX_PATH + 1] = "";
    GetTempPathA(sizeof folder, folder);
    const std::string path = std::string(folder) + "luxpipe-" + std::to_string(random_bits()) + ".tmp";
    const int fd = _open(path.c_str(), _O_RDWR | _O_CREAT | _O_EXCL | _O_TEMPORARY | _O_BINARY | _O_NOINHERIT,
                         _S_IREAD | _S_IWRITE);
    if (fd < 0 || (write_part(fd, text.data(), text.size()) && _lseeki64(fd, 0, SEEK_SET) == 0)) return fd;
    close_descriptor(fd);
    return -1;
}

void close_descriptor(int fd) {
    const int code = errno;
    _close(fd);
    errno = code;
}

ssize_t read_some(int fd, void* data, size_t bytes) {
    errno = 0;
    return _read(fd, data, unsigned(std::min(bytes, most_at_once)));
}

ssize_t read_at(int fd, void* data, size_t bytes, uint64_t place) {
    errno = 0;
    return _lseeki64(fd, int64_t(place), SEEK_SET) < 0 ? -1 : read_some(fd, data, bytes);
}

uint64_t place_in(int fd) { return uint64_t(_telli64(fd)); }

bool write_all(int fd, const void* data, size_t bytes, const void* more, size_t more_bytes) {
    return write_part(fd, data, bytes) && write_part(fd, more, more_bytes);
}

bool is_terminal(int fd) {
    DWORD mode;
    return GetConsoleMode(handle_of(fd), &mode);
}

void widen_pipe(int) {}
bool has_no_reader(int) { return false; }  // the next write tells

bool append_to(int fd, const std::string& path) { return redirect(fd, path.c_str(), _O_CREAT | _O_APPEND); }
void lead_nowhere(int fd) { redirect(fd, "NUL", 0); }

}  // namespace base
