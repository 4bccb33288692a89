// SPDX-License-Identifier: BSD-3-Clause
// Opens what is read.  The user may name anything on the command line: ptrace <(make_scene).  A file that a scene, a
// rad input file or a region file names must be an ordinary one outside /proc, /sys and /dev: FIFOs and devices block,
// and files of the kernel tell about the process (docs/security.md).
#pragma once
#include <string>
#include <utility>
#include "base/files_read.h"

namespace base {

// For whom a file is opened.
struct Opener {
    std::string place;                   // that names the file, as "room.rad:3"; empty: the command line
    const Overlays* overlays = nullptr;  // texts that stand for files
    FilesRead* files = nullptr;          // where it is noted

    Opener(std::string place_ = "", const Overlays* overlays_ = nullptr, FilesRead* files_ = nullptr)
        : place(std::move(place_)), overlays(overlays_), files(files_) {}
    Opener(const char* place_) : place(place_) {}
};

// A descriptor, at the beginning of the file or of its overlay.  It is noted before it is opened: a program that waits
// for changes also waits for a file that does not exist yet.  Throws Error where the file cannot be opened, may not be
// named there, or is the file that the standard output goes to.
int open_file(const std::string& path, const Opener& by);

// Throws Error (place = who) for what exists and may not be named by another file.  For names that are opened later.
void require_ordinary_file(const std::string& path, const std::string& who);

}  // namespace base
