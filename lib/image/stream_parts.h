// SPDX-License-Identifier: BSD-3-Clause
// Shared by readers and writers of RADIANCE pictures: the header, the resolution line, the order of pixels.
#pragma once
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>
#include "image/header.h"
#include "image/input.h"

namespace image {

struct Layout {  // of the resolution line
    int width = 0, height = 0;
    bool x_major = false, x_down = false, y_up = false;
    bool standard() const { return !x_major && !x_down && !y_up; }
};

struct Head {
    Header header;
    Encoding encoding;
    Layout layout;
};
Head read_head(Input& in, const std::string& place);  // up to the pixels

// Byte order of 32-bit float pictures (BigEndian=).
inline bool host_is_big_endian() {
    const uint16_t one = 1;
    uint8_t first;
    std::memcpy(&first, &one, 1);
    return first == 0;
}

// From file order to rows from the top, columns from the left; `channels` values a pixel.
void reorient(std::vector<float>& values, const Layout& layout, size_t channels);

}  // namespace image
