// SPDX-License-Identifier: BSD-3-Clause
// Pictures for people, 8 bits a channel: a photographic tone curve, a straight one, grey, or luminance as colours.
#pragma once
#include <string>
#include <vector>
#include "display/colours.h"
#include "image/picture.h"

namespace display {

struct Image8 {
    int width = 0, height = 0;
    std::vector<uint8_t> rgb;  // row 0 = top
    uint8_t* at(int x, int y) { return &rgb[3 * (size_t(y) * width + x)]; }
    const uint8_t* at(int x, int y) const { return &rgb[3 * (size_t(y) * width + x)]; }
};

struct ToneOptions {
    enum class Kind { photo, linear, grey, falsecolor } kind = Kind::photo;
    double stops = 0;      // not falsecolor: brighter (+) or darker (-) than the automatic exposure, in factors of 2
    double max_cdm2 = 0;   // falsecolor: luminance of the top colour; 0 = chosen from the picture
    double decades = 3;    // falsecolor: decades of luminance from the bottom to the top colour; 0 = linear from 0
    double mask_cdm2 = 0;  // falsecolor: black below this luminance
    int divisions = 8;     // falsecolor: of the scale, for bands and contours
    enum class Style { smooth, bands, contours } style = Style::smooth;
    bool legend = true;  // falsecolor
};

// Reinhard, Stark, Shirley, Ferwerda 2002, "Photographic Tone Reproduction for Digital Images", Eqs. 2 and 4: a
// luminance L (cd/m2) is shown as l (1 + l / white2) / (1 + l) with l = scale L.
struct Exposure {
    double scale = 0, white2 = 1;
};
// Key value and white point chosen from the picture as in Reinhard 2002, "Parameter Estimation for Photographic Tone
// Reproduction" (Journal of Graphics Tools 7).
Exposure automatic_exposure(const image::Picture& picture);

// The luminance scale of falsecolor: top colour (cd/m2) and decades below it (0: linear from 0).
struct Scale {
    double top = 1000, decades = 3;
    double place(double value) const;     // 0 bottom, 1 top
    double value_at(double place) const;  // the inverse
};
Scale falsecolor_scale(const image::Picture& picture, const ToneOptions& options);
ColourTable falsecolor_table(const Scale& scale, const ToneOptions& options);

Image8 photo(const image::Picture& picture, const Exposure& exposure);
Image8 linear(const image::Picture& picture, const Exposure& exposure);  // white is the curve's white point
Image8 grey(const image::Picture& picture, const Exposure& exposure);
Image8 falsecolor(const image::Picture& picture, const ToneOptions& options);
Image8 tone(const image::Picture& picture, const ToneOptions& options);

// The smallest of 1, 2, 5 times a power of ten that is not below the value.
double round_up_125(double value);
std::vector<double> ticks(const Scale& scale);
std::string tick_text(double tick);

}  // namespace display
