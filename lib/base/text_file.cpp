// SPDX-License-Identifier: BSD-3-Clause
// See text_file.h.
#include "base/text_file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>

#include "base/descriptor.h"
#include "base/error.h"
#include "base/files_read.h"
#include "base/printable.h"
#include "base/split.h"

namespace base {

std::string read_text_file(const std::string& path, size_t limit) {
    errno = 0;
    const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (fd < 0) fail_system(path, "cannot be read");
    note_file_read(path);
    std::string text;
    char block[1 << 14];
    ssize_t n;
    while ((n = read_some(fd, block, sizeof block)) > 0 && text.size() <= limit) text.append(block, size_t(n));
    const int code = errno;
    close(fd);
    errno = code;
    if (n < 0) fail_system(path, "cannot be read");
    if (text.size() > limit) fail(path, "is longer than the " + std::to_string(limit) + " bytes such a file may have");
    if (begins_with(text, byte_order_mark)) text.erase(0, byte_order_mark.size());
    return text;
}

void require_ordinary_file(const std::string& path, const std::string& who) {
    struct stat info;
    if (stat(path.c_str(), &info) == 0 && !S_ISREG(info.st_mode) && !S_ISDIR(info.st_mode))
        fail(who, "\"" + excerpt(path) + "\" is not an ordinary file");
}

}  // namespace base
