// SPDX-License-Identifier: BSD-3-Clause
// See text_file.h.
#include "base/text_file.h"

#include "base/descriptor.h"
#include "base/error.h"
#include "base/split.h"

namespace base {

std::string read_text_file(const std::string& path, size_t limit, const Opener& by) {
    const int fd = open_file(path, by);
    std::string text;
    char block[1 << 14];
    ssize_t n;
    while ((n = read_some(fd, block, sizeof block)) > 0 && text.size() <= limit) text.append(block, size_t(n));
    close_descriptor(fd);
    if (n < 0) fail_system(path, "cannot be read");
    if (text.size() > limit) fail(path, "is longer than the " + std::to_string(limit) + " bytes such a file may have");
    if (begins_with(text, byte_order_mark)) text.erase(0, byte_order_mark.size());
    return text;
}

}  // namespace base
