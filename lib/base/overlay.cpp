// SPDX-License-Identifier: BSD-3-Clause
// See overlay.h.
#include "base/overlay.h"

#include <algorithm>
#include <cerrno>
#include <utility>

#include "base/descriptor.h"
#include "base/error.h"

namespace base {

Overlays without_overlay(Overlays overlays, const std::string& path) {
    const FileStamp file = stamp_of(path);
    const auto is_over = [&](const Overlay& x) { return x.file == file || !(stamp_of(x.path) == x.file); };
    overlays.erase(std::remove_if(overlays.begin(), overlays.end(), is_over), overlays.end());
    return overlays;
}

Overlays with_overlay(Overlays overlays, const std::string& path, std::string text) {
    errno = 0;
    const FileStatus file = status_of(path);
    if (file.kind == FileKind::none) fail_system(path, "cannot be overlaid");
    errno = 0;
    if (!file.is_ordinary()) fail_system(path, "is not an ordinary file: no text can replace it");
    overlays = without_overlay(std::move(overlays), path);
    overlays.push_back({path, file.stamp, std::make_shared<const std::string>(std::move(text))});
    return overlays;
}

std::shared_ptr<const std::string> overlay_of(const Overlays& overlays, const FileStamp& file) {
    for (const Overlay& x : overlays)
        if (x.file == file) return x.text;
    return nullptr;
}

int overlaid(int descriptor, const Overlays& overlays) {
    const auto text = overlays.empty() ? nullptr : overlay_of(overlays, status_of(descriptor).stamp);
    if (!text) return descriptor;
    close_descriptor(descriptor);
    errno = 0;
    const int nameless = open_nameless(*text);
    if (nameless < 0) fail_system("overlay", "a temporary file cannot be made and written");
    return nameless;
}

}  // namespace base
