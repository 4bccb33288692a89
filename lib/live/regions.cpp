// SPDX-License-Identifier: BSD-3-Clause
// See regions.h.
#include "live/regions.h"

#include "base/error.h"
#include "display/draw.h"
#include "display/outline.h"
#include "live/json.h"
#include "region/region.h"
#include "region/tokens.h"

namespace live {

namespace {

json::Members::value_type drawn(const region::Regions& regions, size_t k, const image::Picture& p) {
    try {
        if (!p.header.view) return {"trouble", json::text("the picture has no view")};
        const image::MaskSet set =
            region::rasterize(region::only(regions, k), *p.header.view, p.width, p.height, false);
        return {"rings", display::rings_text(display::outlines(set.masks[0].coverage, p.width, p.height))};
    } catch (const base::Error& e) {
        return {"trouble", json::text(e.message)};
    }
}

}  // namespace

bool holds_regions(const std::string& text, const std::string& path) {
    return !region::split_regions(text, path).empty();
}

std::string region_outlines(const std::string& text, const std::string& path, const image::Picture& picture) {
    if (!holds_regions(text, path)) return "[]";
    const region::Regions regions = region::parse(text, path);
    size_t k = 0;
    return json::list_of(regions.regions, [&](const auto& r) {
        const display::Colour c = display::list_colour(k);
        return json::object({{"name", json::text(r.name)},
                             {"colour", json::numbers({double(c[0]), double(c[1]), double(c[2])})},
                             drawn(regions, k++, picture)});
    });
}

}  // namespace live
