// SPDX-License-Identifier: BSD-3-Clause
// Bytes from a file or pipe: small reads through a buffer, large blocks straight into place.
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>
#include "base/open_file.h"

namespace image {

class Input {
public:
    // "-" is stdin, on the command line; throws Error (system) if it cannot be opened.  by: as
    // for base::open_file().
    explicit Input(const std::string& path, const base::Opener& by = {});
    ~Input();
    Input(const Input&) = delete;
    Input& operator=(const Input&) = delete;

    const std::string& name() const { return name_; }
    bool at_end();  // waits for a byte, the end or (between pictures only: base/shutdown.h) a signal that asks to stop
    int get() { return at_ < have_ || fill() ? buffer_[at_++] : -1; }
    size_t read(void* data, size_t bytes);      // fewer only at the end of input
    bool look(void* data, size_t bytes);        // a few bytes ahead, not taken; false if the input ends before
    std::optional<uint64_t> remaining() const;  // bytes left, for regular files

private:
    bool fill();
    size_t read_some(void* data, size_t bytes);
    std::string name_;
    bool own_;
    int fd_ = -1;
    bool end_ = false, regular_ = false;
    std::vector<unsigned char> buffer_;
    size_t at_ = 0, have_ = 0;
};

}  // namespace image
