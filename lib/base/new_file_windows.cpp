// SPDX-License-Identifier: BSD-3-Clause
// See new_file.h.  A new file gets the folder's permissions and owner.  A link is replaced, not the file it names.
#include "base/new_file.h"

#include <fcntl.h>
#include <io.h>
#include <sys/stat.h>
#include <windows.h>

#include <cerrno>
#include <random>

namespace base {

uint64_t random_bits() {
    std::random_device system;
    return uint64_t(system()) << 32 | system();
}

std::string end_of_links(std::string path) { return path; }

int make_new(const std::string& path, unsigned) {
    return _open(path.c_str(), _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

int open_to_write(const std::string& path) { return _open(path.c_str(), _O_WRONLY | _O_BINARY | _O_NOINHERIT); }

void take_permissions(int, const std::string&) {}

bool close_written(int fd) { return _close(fd) == 0; }

// A file that somebody reads, such as vcmetrics or a virus scanner, cannot be replaced for so long: it is tried for two
// seconds.
bool replace_file(const std::string& path, const std::string& target) {
    for (int tries = 0; tries < 40; tries++) {
        if (MoveFileExA(path.c_str(), target.c_str(), MOVEFILE_REPLACE_EXISTING)) return true;
        const DWORD why = GetLastError();
        if (why != ERROR_ACCESS_DENIED && why != ERROR_SHARING_VIOLATION) break;
        Sleep(50);
    }
    errno = EACCES;
    return false;
}

void remove_file(const char* path) { _unlink(path); }

}  // namespace base
