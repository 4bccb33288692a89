// SPDX-License-Identifier: BSD-3-Clause
// The formats of picture files.  CONTRIBUTING.md says how to add one; the tools take it from the table in
// file_format.cpp (man/luxpipe-stream.5 describes them).
#pragma once
#include <string>
#include "base/open_file.h"
#include "image/exr.h"

namespace image {

// Settings for the writers; each uses those that concern its format.
struct WriteOptions {
    Format pixels = Format::rgbe;  // of RADIANCE pictures
    ExrOptions exr;
};

struct FileFormat {
    const char* name;     // for messages
    const char* endings;  // in small letters, each with its dot, separated by blanks
    const char* magic;    // the four bytes that such a file begins with; null: it is not read as a whole file
    Picture (*read)(const std::string& path, const base::Opener& by);
    void (*write)(const std::string& path, const Picture& picture, const WriteOptions& options);
};

// Null where there is none.
const FileFormat* format_by_ending(const std::string& ending);
const FileFormat* format_by_magic(const char* four_bytes);
std::string endings();  // ".hdr .pic .exr", for -help

}  // namespace image
