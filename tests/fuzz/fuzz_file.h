// SPDX-License-Identifier: BSD-3-Clause
// The fuzzer's bytes as a file that has a name, without touching the disk.
#pragma once
#include <cstdint>
#include <string>
#include <sys/mman.h>
#include <unistd.h>

class FuzzFile {
public:
    FuzzFile(const uint8_t* data, size_t size) : fd_(memfd_create("fuzz", 0)) {
        if (fd_ >= 0 && write(fd_, data, size) < 0) path_.clear();
        path_ = "/proc/self/fd/" + std::to_string(fd_);
    }
    ~FuzzFile() {
        if (fd_ >= 0) close(fd_);
    }
    FuzzFile(const FuzzFile&) = delete;
    FuzzFile& operator=(const FuzzFile&) = delete;
    const std::string& path() const { return path_; }

private:
    int fd_;
    std::string path_;
};
