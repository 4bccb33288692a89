// SPDX-License-Identifier: BSD-3-Clause
// Distinguishes two versions of a file; all 0: there is no file.
#pragma once
#include <sys/stat.h>

#include <cstdint>
#include <cstring>
#include <string>

namespace base {

struct FileStamp {
    uint64_t device = 0, inode = 0, size = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const FileStamp& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};

inline FileStamp stamp_of(const struct stat& s) {
#ifdef __APPLE__
    const timespec& changed = s.st_mtimespec;
#else
    const timespec& changed = s.st_mtim;
#endif
    return {uint64_t(s.st_dev), uint64_t(s.st_ino), uint64_t(s.st_size), uint64_t(changed.tv_sec),
            uint64_t(changed.tv_nsec)};
}

inline FileStamp stamp_of(const std::string& path) {
    struct stat s = {};
    return stat(path.c_str(), &s) == 0 ? stamp_of(s) : FileStamp{};
}

}  // namespace base
