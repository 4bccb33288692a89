// SPDX-License-Identifier: BSD-3-Clause
// See file_status.h.
#include "base/file_status.h"

#include <glob.h>
#include <sys/stat.h>
#include <unistd.h>

namespace base {
namespace {

FileStatus status_from(int failed, const struct stat& s) {
    if (failed) return {};
#ifdef __APPLE__
    const timespec& changed = s.st_mtimespec;
#else
    const timespec& changed = s.st_mtim;
#endif
    const FileKind kind = S_ISREG(s.st_mode)    ? FileKind::ordinary
                          : S_ISDIR(s.st_mode)  ? FileKind::folder
                          : S_ISFIFO(s.st_mode) ? FileKind::pipe
                          : S_ISSOCK(s.st_mode) ? FileKind::socket
                                                : FileKind::other;
    return {kind,
            {uint64_t(s.st_dev), uint64_t(s.st_ino), uint64_t(s.st_size), uint64_t(changed.tv_sec),
             uint64_t(changed.tv_nsec)}};
}

}  // namespace

FileStatus status_of(const std::string& path) {
    struct stat s = {};
    return status_from(stat(path.c_str(), &s), s);
}

FileStatus status_of(int descriptor) {
    struct stat s = {};
    return status_from(fstat(descriptor, &s), s);
}

bool is_absolute(const std::string& path) { return path[0] == '/'; }
const char between_folders = ':';

bool may_read(const std::string& path) { return access(path.c_str(), R_OK) == 0; }
bool may_write_in(const std::string& folder) { return access(folder.c_str(), W_OK | X_OK) == 0; }

std::vector<std::string> files_like(const std::string& pattern) {
    glob_t found = {};
    std::vector<std::string> files;
    if (glob(pattern.c_str(), 0, nullptr, &found) == 0) files.assign(found.gl_pathv, found.gl_pathv + found.gl_pathc);
    globfree(&found);
    return files;
}

}  // namespace base
