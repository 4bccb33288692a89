// SPDX-License-Identifier: BSD-3-Clause
// See preview.h.
#include "region/preview.h"
#include <fmt/format.h>
#include "base/error.h"
#include "display/draw.h"
#include "display/file.h"

namespace region {

void write_preview(const std::string& path, const image::Picture& under, const image::MaskSet& set) {
    if (set.width != under.width || set.height != under.height)
        base::fail(path, fmt::format("the picture has {} x {} pixels, the regions {} x {}", under.width, under.height,
                                     set.width, set.height));
    display::Image8 picture = display::tone(under, {});
    std::vector<display::Label> names;
    for (const image::Mask& m : set.masks) {
        const display::Colour colour = display::list_colour(names.size());
        display::draw_area(picture, m.coverage, colour, .45);
        names.push_back({m.name, colour});
    }
    display::write_png(path, display::with_labels(picture, names), "");
}

}  // namespace region
