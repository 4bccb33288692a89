// SPDX-License-Identifier: BSD-3-Clause
// Pictures byte by byte, for tests of what is read of them.
#pragma once
#include <cmath>
#include <cstring>
#include <string>
#include <vector>
#include "image/stream.h"
#include "temp_folder.h"

inline const std::string rgbe_head = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

// value of a byte with exponent e: (byte + .5) 2^(e - 136)
inline float decoded(int byte, int e) { return float(std::ldexp(byte + .5, e - 136)); }

inline std::string floats(const std::vector<float>& values, bool swap = false) {
    std::string out;
    for (const float v : values) {
        char b[4];
        std::memcpy(b, &v, 4);
        if (swap) std::swap(b[0], b[3]), std::swap(b[1], b[2]);
        out.append(b, 4);
    }
    return out;
}

inline image::Picture read(const std::string& bytes) {
    TempFolder temp;
    return image::read_file(temp.holding("x.hdr", bytes));
}

inline std::string why(const std::string& bytes) {
    TempFolder temp;
    const std::string path = temp.holding("x.hdr", bytes);
    const std::string text = error_text([&] { image::read_file(path); });
    return text.compare(0, path.size() + 2, path + ": ") == 0 ? text.substr(path.size() + 2) : text;
}
