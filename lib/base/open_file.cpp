// SPDX-License-Identifier: BSD-3-Clause
// See open_file.h.
#include "base/open_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/error.h"
#include "base/printable.h"
#include "base/split.h"
#include "base/shutdown.h"

namespace base {
namespace {

namespace fs = std::filesystem;

bool is_kernels(const std::string& path) {
    if (begins_with(path, "/dev/")) return !begins_with(path, "/dev/shm/");
    return begins_with(path, "/proc/") || begins_with(path, "/sys/");
}

// Checks the path both as written, because /dev/stdin may lead to an ordinary file, and with its links followed.
bool lies_in_kernels_folders(const std::string& path) {
    std::error_code absent;
    const fs::path written = fs::absolute(path, absent).lexically_normal();
    return is_kernels(written.string()) || is_kernels(fs::canonical(path, absent).string());
}

[[noreturn]] void refuse(const std::string& path, const std::string& who) {
    fail(who, "\"" + excerpt(path) + "\" is not an ordinary file");
}

bool same_file(const struct stat& a, const struct stat& b) { return a.st_dev == b.st_dev && a.st_ino == b.st_ino; }

}  // namespace

void require_ordinary_file(const std::string& path, const std::string& who) {
    struct stat info;
    if (stat(path.c_str(), &info) != 0) return;  // the function that opens it reports this
    if ((!S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode)) || lies_in_kernels_folders(path)) refuse(path, who);
}

int open_file(const std::string& path, const Opener& by) {
    const std::string& asked_by = by.place;
    if (by.files) note_file_read(*by.files, path, by.overlays ? *by.overlays : Overlays{});
    const bool users = asked_by.empty();
    if (!users) require_ordinary_file(path, asked_by);
    struct stat out = {}, info = {};
    const bool writes_file = fstat(1, &out) == 0 && S_ISREG(out.st_mode);
    int fd;
    {
        const EndsSoon opening;  // a FIFO waits for its writer
        errno = 0;
        fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | (users ? 0 : O_NONBLOCK | O_NOCTTY));
    }
    if (fd < 0 && users) fail_system(path, "cannot be read");
    if (fd < 0) fail_system(asked_by, "cannot open \"" + excerpt(path) + "\"");
    const bool known = fstat(fd, &info) == 0;
    const auto close_and = [&](auto refusal) {
        close(fd);
        refusal();
    };
    if (!users && known && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))  // exchanged since it was looked at
        close_and([&] { refuse(path, asked_by); });
    if (known && writes_file && same_file(info, out))
        close_and([&] { fail(users ? path : asked_by, "is the file that the standard output goes to"); });
    return by.overlays ? overlaid(fd, *by.overlays) : fd;
}

}  // namespace base
