// SPDX-License-Identifier: BSD-3-Clause
// Files of pictures for people (PNG), beside those that hold radiances (image/file_format.h).
#pragma once
#include <string>
#include "display/tone.h"
#include "image/stream.h"

namespace display {

// PNG, sRGB, with the text as its comment.
std::string png_bytes(const Image8& image, const std::string& comment);
// Whole or not at all.
void write_png(const std::string& path, const Image8& image, const std::string& comment);
// The picture with its header as comment.  filtered: the pixels that are shown in place of the picture's, as the
// comment then says.
void write_png(const std::string& path, const image::Picture& picture, const ToneOptions& options,
               const std::vector<float>* filtered = nullptr);

// The formats of image/file_format.h and PNG, by the ending of the name.
std::string endings();                                  // ".hdr .pic .exr .png", for -help
void require_writable_ending(const std::string& path);  // as image::require_writable_ending
void write_file(const std::string& path, const image::Picture& picture, const image::WriteOptions& options,
                const ToneOptions& tone = {}, const std::vector<float>* filtered = nullptr);

}  // namespace display
