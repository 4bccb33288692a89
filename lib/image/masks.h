// SPDX-License-Identifier: BSD-3-Clause
// Region masks: an OpenEXR file with one half/float channel per named region, coverage 0..1 (vcregion writes, vcmetrics
// reads).
#pragma once
#include <functional>
#include <string>
#include <vector>
#include "base/open_file.h"
#include "image/picture.h"

namespace image {

struct Mask {
    std::string name;             // letters, digits, _ and -
    std::vector<float> coverage;  // width * height, row 0 = top, 0..1
};
struct MaskSet {
    int width = 0, height = 0;
    std::vector<Mask> masks;  // in file order (kept in the attribute "luxpipe.regions")
    Header header;
};
// Regions of a file that fits any view and size, drawn when these are known (lib/region/region.h).
using DrawRegions = std::function<MaskSet(const view::View& view, int width, int height)>;

MaskSet read_masks(const std::string& path, const base::Opener& by = {});
void write_masks(const std::string& path, const MaskSet& set);

}  // namespace image
