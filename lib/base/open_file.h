// SPDX-License-Identifier: BSD-3-Clause
// Opens what is read.  The user may name anything on the command line: ptrace <(make_scene).  A file that a scene, a
// rad input file or a region file names must be an ordinary one outside /proc, /sys and /dev: FIFOs and devices block,
// and files of the kernel tell about the process (docs/security.md).
#pragma once
#include <string>

namespace base {

// A descriptor, at the beginning of the file or of its overlay (overlay.h), noted for files_read().  asked_by: the
// place that names the file, as "room.rad:3"; empty: the command line.  Throws Error where the file cannot be opened,
// may not be named there, or is the file that the standard output goes to.
int open_file(const std::string& path, const std::string& asked_by);

// Throws Error (place = who) for what exists and may not be named by another file.  For names that are opened later.
void require_ordinary_file(const std::string& path, const std::string& who);

}  // namespace base
