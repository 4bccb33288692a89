// SPDX-License-Identifier: BSD-3-Clause
// Pictures for people, 8 bits a channel: a photographic tone curve, or luminance as colours with a legend.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>
#include "image/picture.h"

namespace image {

struct ToneOptions {
    enum class Kind { photo, falsecolor } kind = Kind::photo;
    double stops = 0;     // photo: brighter (+) or darker (-) than the automatic exposure, in factors of 2
    double max_cdm2 = 0;  // falsecolor: luminance of the top colour; 0 = chosen from the picture
    double decades = 3;   // falsecolor: decades of luminance from the bottom to the top colour; 0 = linear from 0
    bool legend = true;   // falsecolor
};

struct Image8 {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;  // row 0 = top
    uint8_t* at(int x, int y) { return &rgb[3 * (size_t(y) * width + x)]; }
    const uint8_t* at(int x, int y) const { return &rgb[3 * (size_t(y) * width + x)]; }
};

Image8 photo(const Picture& picture, const ToneOptions& options);
Image8 falsecolor(const Picture& picture, const ToneOptions& options);
Image8 tone(const Picture& picture, const ToneOptions& options);

// The colour ramp, t in [0,1]: dark violet, blue, teal, green, yellow, orange, pale red; luminance rises throughout.
std::array<uint8_t, 3> ramp(double t);

// The smallest of 1, 2, 5 times a power of ten that is not below the value.
double round_up_125(double value);

// Glyphs of 5 x 7 for digits, letters (drawn small) and . - + / _; unknown characters are blanks (font.cpp).
void draw_text(Image8& image, int x, int y, const std::string& text, int scale, std::array<uint8_t, 3> color);
int text_width(const std::string& text, int scale);

// PNG, sRGB, with the picture's header as comment; whole or not at all.  filtered: the pixels that are shown in place
// of the picture's, as the comment says then.
std::string png_bytes(const Image8& image, const std::string& comment);
void write_png(const std::string& path, const Picture& picture, const ToneOptions& options,
               const std::vector<float>* filtered = nullptr);

}  // namespace image
