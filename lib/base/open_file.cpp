// SPDX-License-Identifier: BSD-3-Clause
// See open_file.h.
#include "base/open_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>

#include "base/descriptor.h"
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

bool may_be_named(FileKind kind) { return kind == FileKind::ordinary || kind == FileKind::folder; }

}  // namespace

void require_ordinary_file(const std::string& path, const std::string& who) {
    const FileKind kind = status_of(path).kind;
    if (kind == FileKind::none) return;  // the function that opens it reports this
    if (!may_be_named(kind) || lies_in_kernels_folders(path)) refuse(path, who);
}

int open_file(const std::string& path, const Opener& by) {
    const std::string& asked_by = by.place;
    if (by.files) note_file_read(*by.files, path, by.overlays ? *by.overlays : Overlays{});
    const bool users = asked_by.empty();
    if (!users) require_ordinary_file(path, asked_by);
    const FileStatus out = status_of(1);
    int fd;
    {
        const EndsSoon opening;  // a FIFO waits for its writer
        errno = 0;
        fd = open_to_read(path, users);
    }
    if (fd < 0 && users) fail_system(path, "cannot be read");
    if (fd < 0) fail_system(asked_by, "cannot open \"" + excerpt(path) + "\"");
    const FileStatus info = status_of(fd);
    const bool known = info.kind != FileKind::none;
    const auto close_and = [&](auto refusal) {
        close_descriptor(fd);
        refusal();
    };
    if (!users && known && !may_be_named(info.kind))  // exchanged since it was looked at
        close_and([&] { refuse(path, asked_by); });
    if (known && out.is_ordinary() && info.is_same_file(out))
        close_and([&] { fail(users ? path : asked_by, "is the file that the standard output goes to"); });
    return by.overlays ? overlaid(fd, *by.overlays) : fd;
}

}  // namespace base
