// SPDX-License-Identifier: BSD-3-Clause
// Glare sources of a picture, and the light in them.
#pragma once
#include <optional>
#include <vector>
#include "glare/connected_components.h"
#include "glare/settings.h"
#include "glare/statistics.h"

namespace glare {

struct GlareSource {
    double pixels = 0, omega = 0, lum = 0;  // omega-weighted mean luminance
    double x = 0, y = 0;                    // mean of the pixels weighted by L w; y from the bottom
    double brightest = 0;
    double eye_lux = 0;  // its share of the direct illuminance: sum L w cos
    int zone = 0;
    uint32_t group = 0;                          // evalglare's number, from 1
    double P = 1, sigma_deg = 0, theta_deg = 0;  // theta: sigma, unless evalglare's centre has no direction
    Vec3 direction;                              // of the pixel that contains the centre
};

// Sets of pixels that statistics are asked of (-B, -A, -l, -L).
struct PixelSets {
    std::optional<std::vector<uint32_t>> band, mask, zone1, zone2;
};
struct SetStatistics {
    std::optional<PixelStatistics> band, mask, zone1, zone2;
};

struct Sources {
    std::vector<GlareSource> sources;  // split at the borders of zones (-l, -L)
    std::vector<Run> runs;             // their pixels, groups from 1
    double direct_lux = 0;
    std::vector<GlareSource> before_zones;  // for evalglare's lines
    std::vector<Run> runs_before_zones;     // where zones split them; else empty
    SetStatistics sets;
};

// Connected components of bright pixels, smoothed (-s), without their peaks (-y); or fixed patches (-z).
// classification_image: decides which pixels are bright and which are peaks.
// components: of the geometry's directions.
Sources find_sources(const Luminance& lum, const Luminance& classification_image, const Geometry& geometry,
                     const ConnectedComponents& components, const Settings& settings, double threshold,
                     const PixelSets& sets);

// A pixel of a group.
struct GroupPixel {
    uint32_t column_key, pixel, group;
};
// All pixels of runs, columns from the left, in a column from the bottom: evalglare's order.
std::vector<GroupPixel> column_order(const std::vector<Run>& runs, const Geometry& geometry);

GlareTerms terms_of(const std::vector<GlareSource>& sources);
// Sums of the formulas: over the sources, or with DgpForm::pixel over every bright pixel.
GlareTerms glare_terms(const Luminance& lum, const Luminance& classification_image, const Geometry& geometry,
                       const Settings& settings, double threshold, const std::vector<GlareSource>& sources);

// -z: group of every pixel on evalglare's staggered grid of patches; returns the number of patches.
uint32_t assign_patches(std::vector<Run>& runs, const Geometry& geometry, const Patches& patches);

}  // namespace glare
