// SPDX-License-Identifier: BSD-3-Clause
// Kind and version of a file, by its name or by a descriptor.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace base {

// Distinguishes two versions of a file; all 0: there is no file.
struct FileStamp {
    uint64_t device = 0, inode = 0, size = 0, seconds = 0, nanoseconds = 0;
    bool operator==(const FileStamp& other) const { return std::memcmp(this, &other, sizeof other) == 0; }
};

enum class FileKind { none, ordinary, folder, pipe, socket, other };

struct FileStatus {
    FileKind kind = FileKind::none;
    FileStamp stamp;
    bool is_ordinary() const { return kind == FileKind::ordinary; }
    // Under whatever names.
    bool is_same_file(const FileStatus& other) const {
        return stamp.device == other.stamp.device && stamp.inode == other.stamp.inode;
    }
};

// Links are followed.  none: errno says why.
FileStatus status_of(const std::string& path);
FileStatus status_of(int descriptor);
inline FileStamp stamp_of(const std::string& path) { return status_of(path).stamp; }

bool is_absolute(const std::string& path);
extern const char between_folders;  // of RAYPATH

// False: errno says why.
bool may_read(const std::string& path);
bool may_write_in(const std::string& folder);

// The files that a pattern of * and ? means, in order; none: nothing has such a name.
std::vector<std::string> files_like(const std::string& pattern);

}  // namespace base
