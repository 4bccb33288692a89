// SPDX-License-Identifier: BSD-3-Clause
// Texts that are read in place of files, each until its file changes on disk (ptrace -control), so that a user can try
// a number without saving it.  They are a value: who reads with them is given them (open_file.h, find_file.h).
#pragma once
#include <memory>
#include <string>
#include <vector>
#include "base/file_status.h"

namespace base {

struct Overlay {
    std::string path;
    FileStamp file;  // the same under each of its names, and another one as soon as it is written
    std::shared_ptr<const std::string> text;
};
using Overlays = std::vector<Overlay>;

// With this text for the file, and without one.  Throws Error (place: the path) where there is no such file.
Overlays with_overlay(Overlays overlays, const std::string& path, std::string text);
Overlays without_overlay(Overlays overlays, const std::string& path);

// The text that stands for a file, or null.
std::shared_ptr<const std::string> overlay_of(const Overlays& overlays, const FileStamp& file);
// The descriptor of an open file, or one of the text that stands for it, in exchange.
int overlaid(int descriptor, const Overlays& overlays);

}  // namespace base
