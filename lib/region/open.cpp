// SPDX-License-Identifier: BSD-3-Clause
// Masks as they are, or a region file drawn for the current view (open.h).
#include "region/open.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <memory>
#include "base/error.h"
#include "region/region.h"

namespace region {
namespace {

bool is_exr(const std::string& path) {
    std::error_code absent;
    if (!std::filesystem::is_regular_file(path, absent)) return false;  // a pipe is read once, as text
    const char magic[4] = {0x76, 0x2f, 0x31, 0x01};
    char start[4] = {};
    std::ifstream(path, std::ios::binary).read(start, 4);
    return std::equal(start, start + 4, magic);
}

}  // namespace

image::MaskSet open(const std::string& path, image::DrawRegions& draw, Check check, bool may_be_empty,
                    base::FilesRead* read_files) {
    if (read_files) base::note_file_read(*read_files, path);
    if (is_exr(path)) return image::read_masks(path);
    auto regions = std::make_shared<Regions>(read(path, may_be_empty));
    for (const Shape& s : regions->shapes)
        if (s.kind == Kind::surface || s.kind == Kind::modifier)
            base::fail(s.place,
                       "asks the scene for a surface or modifier: make masks of it with vcregion and the scene, "
                       "and use those");
    if (read_files)
        for (const std::string& mask : mask_files(*regions)) base::note_file_read(*read_files, mask);
    image::MaskSet set;
    for (const Region& r : regions->regions) set.masks.push_back({r.name, {}});
    draw = [regions, check](const view::View& view, int width, int height) {
        image::MaskSet drawn = rasterize(*regions, view, width, height, false);
        if (check != Check::none) check_sizes(*regions, count_pixels(drawn, view), check == Check::empty_and_small);
        return drawn;
    };
    return set;
}

}  // namespace region
