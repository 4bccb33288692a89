// SPDX-License-Identifier: BSD-3-Clause
// Commands to a FIFO that a renderer reads, and lines from one that programs write, without ever waiting for them.
#pragma once
#include <string>
#include <vector>

namespace live {

enum class Written { whole, busy, nobody };
// All bytes, or none: `busy` where what has not been read yet leaves no room for them.
Written write_whole(const std::string& fifo, const std::string& bytes);

class FifoLines {
public:
    explicit FifoLines(const std::string& fifo);  // throws base::Error (system)
    ~FifoLines();
    FifoLines(const FifoLines&) = delete;
    std::vector<std::string> read();                   // those that have come since
    const std::string& rest() const { return rest_; }  // of a line that has not ended
    int descriptor() const { return fd_; }

private:
    int fd_;
    std::string rest_;
};

}  // namespace live
