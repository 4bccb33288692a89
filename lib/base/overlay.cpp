// SPDX-License-Identifier: BSD-3-Clause
// See overlay.h.  The table is kept by the files' stamps: a file is the same under each of its names, and another one
// as soon as it is written.
#include "base/overlay.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <mutex>
#include <utility>
#include <vector>

#include "base/error.h"

namespace base {
namespace {

struct Overlay {
    std::string path, text;
    FileStamp file;
    uint64_t number;
};

struct Overlays {
    std::mutex lock;
    std::vector<Overlay> all;
    uint64_t count = 0;  // of all that ever were
};

Overlays& overlays() {
    static Overlays o;
    return o;
}

// Opens a nameless temporary file with this text, at its beginning.
int descriptor_of(const std::string& text) {
    errno = 0;
    FILE* file = std::tmpfile();
    if (!file) fail_system("overlay", "no temporary file can be made");
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size() && std::fflush(file) == 0;
    std::rewind(file);
    const int fd = written ? fcntl(fileno(file), F_DUPFD_CLOEXEC, 0) : -1;
    const int code = errno;
    std::fclose(file);
    errno = code;
    if (fd < 0) fail_system("overlay", "the temporary file cannot be written");
    return fd;
}

}  // namespace

void remove_overlay(const std::string& path) {
    Overlays& o = overlays();
    const FileStamp file = stamp_of(path);
    const std::lock_guard<std::mutex> hold(o.lock);
    const auto is_over = [&](const Overlay& x) { return x.file == file || !(stamp_of(x.path) == x.file); };
    o.all.erase(std::remove_if(o.all.begin(), o.all.end(), is_over), o.all.end());
}

void set_overlay(const std::string& path, std::string text) {
    errno = 0;
    struct stat s = {};
    if (stat(path.c_str(), &s) != 0) fail_system(path, "cannot be overlaid");
    errno = 0;
    if (!S_ISREG(s.st_mode)) fail_system(path, "is not an ordinary file: no text can replace it");
    remove_overlay(path);
    Overlays& o = overlays();
    const std::lock_guard<std::mutex> hold(o.lock);
    o.all.push_back({path, std::move(text), stamp_of(s), ++o.count});
}

uint64_t overlay_number(const FileStamp& file) {
    Overlays& o = overlays();
    const std::lock_guard<std::mutex> hold(o.lock);
    const auto found = std::find_if(o.all.begin(), o.all.end(), [&](const Overlay& x) { return x.file == file; });
    return found == o.all.end() ? 0 : found->number;
}

int overlaid(int descriptor) {
    Overlays& o = overlays();
    const std::lock_guard<std::mutex> hold(o.lock);
    struct stat s = {};
    if (o.all.empty() || fstat(descriptor, &s) != 0) return descriptor;
    const FileStamp file = stamp_of(s);
    const auto found = std::find_if(o.all.begin(), o.all.end(), [&](const Overlay& x) { return x.file == file; });
    if (found == o.all.end()) return descriptor;
    close(descriptor);
    return descriptor_of(found->text);
}

}  // namespace base
