// SPDX-License-Identifier: BSD-3-Clause
// OpenEXR pictures: R G B (or Y) half or float, scanline or tiled, any compression, with the RADIANCE header in
// the string attribute "radianceHeader" and whiteLuminance = 179 (cd/m2 of R = G = B = 1).
#pragma once
#include <string>
#include "base/open_file.h"
#include "image/picture.h"

namespace image {

struct ExrOptions {
    bool half = false;          // 16-bit floats: smaller, 3 digits, at most 65504
    bool coarse_parts = false;  // part_offsets.h
    bool tiled = false;
    std::string compression = "zip";  // none rle zips zip piz pxr24 b44 b44a dwaa dwab
};

Picture read_exr(const std::string& path, const base::Opener& by = {});
std::string exr_bytes(const std::string& path, const Picture& picture, const ExrOptions& options = {});  // of that file
void write_exr(const std::string& path, const Picture& picture, const ExrOptions& options = {});

}  // namespace image
