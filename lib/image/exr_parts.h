// SPDX-License-Identifier: BSD-3-Clause
// Shared by reading and writing OpenEXR files: limits, and checks of a file's own claims before OpenEXR uses them.
#pragma once
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <cstdint>
#include <string>

namespace image {

constexpr int most_side = 32768, block_lines = 64;
constexpr int64_t most_block = 256 << 20;  // bytes of a tile or of the lines that are decoded together

// OpenEXR's messages, which may have several lines.
std::string one_line(const char* text);

// Throws Error if an attribute of any header has a length that its type or the file of so many bytes cannot have.
void check_attributes(Imf::IStream& in, uint64_t bytes, const std::string& path);

// Throws Error where nothing of the picture is in the file, warns where part of it is not.
void check_windows(const Imf::Header& header, const std::string& path);

// Throws Error for tiles or blocks of lines that are too large to decode.
void check_blocks(const Imf::Header& header, const std::string& path);

}  // namespace image
