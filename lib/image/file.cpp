// SPDX-License-Identifier: BSD-3-Clause
// Whole files, their format chosen by the ending of their name.
#include <cctype>
#include <cerrno>
#include <cstdio>

#include "base/error.h"
#include "base/tempfile.h"
#include "image/exr.h"
#include "image/stream.h"
#include "image/tone.h"

namespace image {

std::string ending_of(const std::string& path) {
    const size_t slash = path.rfind('/');
    const size_t dot = path.rfind('.');
    if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return "";
    std::string e = path.substr(dot);
    for (char& c : e) c = char(std::tolower((unsigned char)c));
    return e;
}

void require_writable_ending(const std::string& path) {
    const std::string e = ending_of(path);
    for (const char* known : {".hdr", ".pic", ".exr", ".png"})
        if (e == known) return;
    base::fail(path, "the ending of the name must be .hdr, .pic, .exr or .png");
}

void write_bytes(const std::string& path, const std::string& bytes) {
    base::TempFile temp(path);
    errno = 0;
    std::FILE* file = std::fopen(temp.path().c_str(), "wb");
    if (!file) base::fail_system(path, "cannot be written");
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const int code = errno;
    const bool closed = std::fclose(file) == 0;
    if (!written) errno = code;
    if (!written || !closed) base::fail_system(path, "cannot be written");
    temp.keep();
}

Picture read_file(const std::string& path, Pixels pixels) {
    StreamReader in(path, pixels);
    Picture picture;
    in.next(picture);
    Picture further;
    if (in.next(further)) base::fail(path, "holds several pictures where one is wanted");
    return picture;
}

void write_file(const std::string& path, const Picture& picture, Format hdr_format) {
    require_writable_ending(path);
    const std::string e = ending_of(path);
    if (e == ".exr") write_exr(path, picture);
    else if (e == ".png") write_png(path, picture, ToneOptions());
    else write_bytes(path, picture_bytes(picture, hdr_format));
}

}  // namespace image
