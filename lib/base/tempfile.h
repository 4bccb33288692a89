// SPDX-License-Identifier: BSD-3-Clause
// A file that appears whole or not at all: write to path(), then keep() renames it to the target.
// Without keep(), or at SIGINT/SIGTERM under base::run(), it is removed.
// A target that exists and is no regular file (/dev/null, a FIFO) is written directly.
#pragma once
#include <string>

namespace base {

class TempFile {
public:
    explicit TempFile(const std::string& target);  // same folder as the target, so that rename is atomic
    ~TempFile();
    TempFile(const TempFile&) = delete;
    TempFile& operator=(const TempFile&) = delete;
    const std::string& path() const { return path_; }
    void keep();  // throws Error (system) if the rename fails

private:
    void name_temp(const std::string& target);
    std::string target_, path_;
    int slot_ = -1;
    bool kept_ = false, direct_ = false;
};

}  // namespace base
