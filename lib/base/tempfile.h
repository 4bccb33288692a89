// SPDX-License-Identifier: BSD-3-Clause
// A file that appears whole or not at all: write to it, then keep() renames it to the target.
// Without keep(), or at SIGINT/SIGTERM under base::run(), it is removed.
// The temporary stands beside the target under a name nobody can guess, and is made new: a file or link that is there
// already is never written to.  It takes the permissions of the file it replaces.
// A target that is a symbolic link stays one: what it names is made or replaced.
// That it is none of the inputs is checked by who knows them (base::refuse_to_overwrite).
// A target that exists and is not a regular file (/dev/null, a FIFO) is written directly.
#pragma once
#include <cstddef>
#include <string>

namespace base {

class TempFile {
public:
    explicit TempFile(const std::string& target);  // same folder as the target, so that rename is atomic
    ~TempFile();
    TempFile(const TempFile&) = delete;
    TempFile& operator=(const TempFile&) = delete;
    const std::string& path() const { return path_; }
    void write(const void* data, size_t bytes);  // throws Error (system), also where the file gets too large
    void keep();                                 // throws Error (system) if closing or renaming fails

private:
    void create(unsigned permissions);
    void remember();
    std::string target_, path_;
    int fd_ = -1, slot_ = -1;
    bool kept_ = false, direct_ = false;
};

// For a signal handler: unlinks every temporary file that is not kept yet.
void remove_temp_files();

}  // namespace base
