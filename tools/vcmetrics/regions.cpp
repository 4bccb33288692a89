// SPDX-License-Identifier: BSD-3-Clause
// Masks as they are, or a region file drawn for the current view (regions.h).
#include "regions.h"
#include <algorithm>
#include <fstream>
#include <memory>
#include "base/error.h"
#include "region/region.h"

image::MaskSet open_regions(const std::string& path, comfort::DrawRegions& draw) {
    const char magic[4] = {0x76, 0x2f, 0x31, 0x01};
    char start[4] = {};
    std::ifstream(path, std::ios::binary).read(start, 4);
    if (std::equal(start, start + 4, magic)) return image::read_masks(path);

    auto regions = std::make_shared<region::Regions>(region::read(path));
    for (const region::Shape& s : regions->shapes)
        if (s.kind == region::Kind::surface || s.kind == region::Kind::modifier)
            base::fail(s.place,
                       "asks the scene for a surface or modifier: make masks of it with vcregion and the scene, "
                       "and use those");
    image::MaskSet set;
    for (const region::Region& r : regions->regions) set.masks.push_back({r.name, {}});
    draw = [regions](const view::View& view, int width, int height) {
        image::MaskSet drawn = region::rasterize(*regions, view, width, height, false);
        region::check_sizes(*regions, region::count_pixels(drawn, view));
        return drawn;
    };
    return set;
}
