// SPDX-License-Identifier: BSD-3-Clause
// See filled.h.
#include "glare/filled.h"

#include <algorithm>

#include "glare/measure.h"

namespace glare {

constexpr double least_share = 1e-9;  // least fraction: 1e-5 of the sun's fraction of a pixel of 3 degrees

Luminance FilledPixels::as(const Luminance& picture) {
    Luminance out = picture;
    out.grey = grey.data();
    out.share = share.data();
    return out;
}

FilledPixels filled_pixels(const Luminance& picture) {
    FilledPixels out;
    out.grey.assign(picture.grey, picture.grey + picture.size());
    out.share.assign(picture.size(), 1.0f);
    for (size_t i = 0; i < out.grey.size(); ++i) {
        const double m1 = out.grey[i], v = (*picture.moments)[image::moment_numbers * i + image::moment_variance];
        if (!(v > 0) || !(m1 > 0)) continue;
        out.share[i] = float(std::max(least_share, m1 * m1 / (m1 * m1 + v)));
        out.grey[i] = float(m1 / out.share[i]);
    }
    return out;
}

Measurement PictureAnalyzer::measure_filled(const Luminance& lum, const Luminance& classification_image,
                                            SourceFinder& of_centres, const Measurement& m) const {
    const std::unique_ptr<SourceFinder> of_places = placed_geometry_ ? make_finder(*placed_geometry_) : nullptr;
    const Geometry& geometry = placed_geometry_ ? *placed_geometry_ : *geometry_;
    SourceFinder& finder = of_places ? *of_places : of_centres;
    Luminance classification = classification_image;
    classification.moments = lum.moments;
    FilledPixels own = filled_pixels(lum), classified = filled_pixels(classification);
    const Luminance light = own.as(lum), bright = classified.as(classification);
    Measurement out = m;
    out.ev = m.placed_ev;
    finder.find_groups(light, bright, m.threshold);
    out.sources = finder.split(light);
    out.direct_lux = finder.direct_lux();
    out.glare = glare_terms(light, bright, geometry, settings_, m.threshold, out.sources);
    out.any_source = !out.sources.empty();
    background_and_dgp(finder, out);
    return out;
}

}  // namespace glare
