// SPDX-License-Identifier: BSD-3-Clause
// See file.h.
#include "display/file.h"

#include "image/header.h"

namespace display {
namespace {
bool is_png(const std::string& path) { return image::ending_of(path) == ".png"; }
}  // namespace

std::string endings() { return image::endings() + " .png"; }

void require_writable_ending(const std::string& path) { image::require_writable_ending(path, {".png"}); }

void write_png(const std::string& path, const Image8& image, const std::string& comment) {
    image::write_bytes(path, png_bytes(image, comment));
}

void write_png(const std::string& path, const image::Picture& picture, const ToneOptions& options,
               const std::vector<float>* filtered) {
    std::string comment;
    for (const std::string& line : image::header_lines(picture.header)) comment += line + "\n";
    if (!filtered) return write_png(path, tone(picture, options), comment + "FILTERED= no\n");
    image::Picture shown = picture;
    shown.rgb = *filtered;
    comment += "FILTERED= non-local means of two halves of the frames, for viewing only\n";
    write_png(path, tone(shown, options), comment);
}

void write_file(const std::string& path, const image::Picture& picture, const image::WriteOptions& options,
                const ToneOptions& tone, const std::vector<float>* filtered) {
    if (!is_png(path)) return image::write_file(path, picture, options);
    require_writable_ending(path);
    write_png(path, picture, tone, filtered);
}

}  // namespace display
