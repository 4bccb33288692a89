// SPDX-License-Identifier: BSD-3-Clause
// The table of picture file formats; see file_format.h.
#include "image/file_format.h"

#include <cstring>
#include <sstream>

#include "image/stream.h"

namespace image {
namespace {

void radiance(const std::string& path, const Picture& picture, const WriteOptions& options) {
    write_bytes(path, picture_bytes(picture, options.pixels));
}
void exr(const std::string& path, const Picture& picture, const WriteOptions& options) {
    write_exr(path, picture, options.exr);
}

// RADIANCE pictures are read as streams (stream_reader.cpp).
const FileFormat formats[] = {
    {"RADIANCE", ".hdr .pic", nullptr, nullptr, radiance},
    {"OpenEXR", ".exr", "\x76\x2f\x31\x01", read_exr, exr},
};

std::vector<std::string> endings_of(const FileFormat& format) {
    std::istringstream in(format.endings);
    std::vector<std::string> all;
    for (std::string one; in >> one;) all.push_back(one);
    return all;
}

}  // namespace

const FileFormat* format_by_ending(const std::string& ending) {
    for (const FileFormat& f : formats)
        for (const std::string& e : endings_of(f))
            if (e == ending) return &f;
    return nullptr;
}

const FileFormat* format_by_magic(const char* four_bytes) {
    for (const FileFormat& f : formats)
        if (f.magic && std::memcmp(f.magic, four_bytes, 4) == 0) return &f;
    return nullptr;
}

std::string endings() {
    std::string text;
    for (const FileFormat& f : formats) text += (text.empty() ? "" : " ") + std::string(f.endings);
    return text;
}

}  // namespace image
