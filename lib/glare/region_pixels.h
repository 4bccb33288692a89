// SPDX-License-Identifier: BSD-3-Clause
// Named regions of the picture (masks of coverage 0..1, written by vcregion): task area luminance and other statistics.
//   TAL = sum c w L / sum c w over valid pixels, c the coverage (paper Eq. 3);  contrast ratio CR = TAL_low / TAL_high
//   (paper Eq. 4; above 0.25 is intolerable).
#pragma once
#include <string>
#include <vector>
#include "glare/geometry.h"
#include "glare/luminance.h"

namespace glare {

struct RegionValues {
    double tal = 0;  // cd/m2
    double mean = 0, median = 0, lowest = 0,
           highest = 0;  // mean weighted by coverage; median of pixels covered by half or more
    double share = 0;    // of the field of view's solid angle
};

// The pixels of one region in one geometry.
class RegionPixels {
public:
    RegionPixels(const std::vector<float>& coverage, const Geometry& geometry);
    double tal(const Luminance& lum) const;
    RegionValues measure(const Luminance& lum) const;

private:
    struct Member {
        uint32_t pixel;
        float coverage;
        double weight;
    };
    std::vector<Member> members_;
    double weight_ = 0, share_ = 0;
};

// column: "low/high" or a given name
struct ContrastPair {
    std::string low, high, column;
};

// Contrast pairs as typed, "low/high" or "screen=low/high".
ContrastPair parse_pair(const std::string& text);
// Throws Error where one of the two is no region.
void require_regions(const ContrastPair& pair, const std::vector<std::string>& regions);

}  // namespace glare
