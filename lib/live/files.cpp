// SPDX-License-Identifier: BSD-3-Clause
// See files.h.
#include "live/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <utility>

#include "base/descriptor.h"
#include "base/hash.h"
#include "image/stream.h"
#include "live/regions.h"
#include "region/region.h"

namespace live {

FileNow TextFile::read() const {
    const int fd = open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) return {"none", "", ""};
    struct stat info = {};
    FileNow now;
    if (fstat(fd, &info) != 0 || !S_ISREG(info.st_mode)) now.trouble = "is not an ordinary file";
    else if (size_t(info.st_size) > longest_file) now.trouble = "is too long to be edited here";
    char block[1 << 14];
    for (ssize_t n; now.trouble.empty() && (n = base::read_some(fd, block, sizeof block)) > 0;)
        now.text.append(block, size_t(n));
    close(fd);
    now.tag = now.trouble.empty() ? base::hash_of(now.text) : "none";
    return now;
}

bool TextFile::write(const std::string& text, const std::string& tag) const {
    if (kind == Kind::regions && holds_regions(text, path)) region::parse(text, path);
    const FileNow now = read();
    if (!now.trouble.empty()) base::fail(path, now.trouble);
    if (now.tag != tag) return false;
    image::write_bytes(path, text);
    return true;
}

bool TextFile::changed() {
    const std::optional<base::FileStamp> before = std::exchange(stamp_, base::stamp_of(path));
    return before && !(*before == *stamp_);
}

}  // namespace live
