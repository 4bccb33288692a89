// SPDX-License-Identifier: BSD-3-Clause
// See overlay.h.
#include "base/overlay.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <utility>

#include "base/error.h"

namespace base {
namespace {

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

Overlays without_overlay(Overlays overlays, const std::string& path) {
    const FileStamp file = stamp_of(path);
    const auto is_over = [&](const Overlay& x) { return x.file == file || !(stamp_of(x.path) == x.file); };
    overlays.erase(std::remove_if(overlays.begin(), overlays.end(), is_over), overlays.end());
    return overlays;
}

Overlays with_overlay(Overlays overlays, const std::string& path, std::string text) {
    errno = 0;
    struct stat s = {};
    if (stat(path.c_str(), &s) != 0) fail_system(path, "cannot be overlaid");
    errno = 0;
    if (!S_ISREG(s.st_mode)) fail_system(path, "is not an ordinary file: no text can replace it");
    overlays = without_overlay(std::move(overlays), path);
    overlays.push_back({path, stamp_of(s), std::make_shared<const std::string>(std::move(text))});
    return overlays;
}

std::shared_ptr<const std::string> overlay_of(const Overlays& overlays, const FileStamp& file) {
    for (const Overlay& x : overlays)
        if (x.file == file) return x.text;
    return nullptr;
}

int overlaid(int descriptor, const Overlays& overlays) {
    struct stat s = {};
    if (overlays.empty() || fstat(descriptor, &s) != 0) return descriptor;
    const auto text = overlay_of(overlays, stamp_of(s));
    if (!text) return descriptor;
    close(descriptor);
    return descriptor_of(*text);
}

}  // namespace base
