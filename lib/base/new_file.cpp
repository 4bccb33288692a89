// SPDX-License-Identifier: BSD-3-Clause
// See new_file.h.
#include "base/new_file.h"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>

#include "base/error.h"

namespace base {

uint64_t random_bits() {
    uint64_t bits;
    if (getentropy(&bits, sizeof bits) != 0) fail_system("", "no random numbers from the system");
    return bits;
}

std::string end_of_links(std::string path) {
    char to[4096];
    for (int links = 0;; ++links) {
        const ssize_t n = readlink(path.c_str(), to, sizeof to);
        if (n <= 0 || n == ssize_t(sizeof to)) return path;
        errno = ELOOP;
        if (links == 40) fail_system(path, "cannot be written");
        const size_t folder = to[0] == '/' ? 0 : path.rfind('/') + 1;  // 0 where there is no slash
        path = path.substr(0, folder) + std::string(to, size_t(n));
    }
}

int make_new(const std::string& path, unsigned permissions) {
    return open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, permissions);
}

int open_to_write(const std::string& path) { return open(path.c_str(), O_WRONLY | O_CLOEXEC); }

// Owner first, where we may give files away (root): the permissions are meant for the old owner.
void take_permissions(int fd, const std::string& of) {
    struct stat old = {};
    if (stat(of.c_str(), &old) != 0) return;
    if (fchown(fd, old.st_uid, old.st_gid) != 0) errno = 0;
    fchmod(fd, old.st_mode & 0777);
}

bool close_written(int fd) { return close(fd) == 0; }

bool replace_file(const std::string& path, const std::string& target) {
    return std::rename(path.c_str(), target.c_str()) == 0;
}

void remove_file(const char* path) { unlink(path); }

}  // namespace base
