// SPDX-License-Identifier: BSD-3-Clause
// Glare sources of swayed pictures, of all at once: what SourceFinder finds by default in each of them.
#pragma once
#include <vector>
#include "comfort/connect.h"
#include "comfort/settings.h"
#include "comfort/sources.h"
#include "comfort/calmed.h"

namespace comfort {

// The source pixels of one picture of `bright`: as that picture of `lum` shows them, and as the mean does.
struct SwayedSources {
    std::vector<GlareSource> own, of_mean;
};

// Whether all_sources() can do what is asked for.
bool sources_at_once(const Settings& settings);

// Of each picture, and last of the mean of `bright` itself.  thresholds: likewise, cd/m2.  bright_in_mean: the pixels
// of lum's mean above the lowest of them, in picture order.  Sources have no brightest pixel, group or zone.
std::vector<SwayedSources> all_sources(const Swayed& lum, const Calmed& bright, const std::vector<double>& thresholds,
                                       const std::vector<Run>& bright_in_mean, const Geometry& geometry,
                                       const Settings& settings, Connector& connector);

}  // namespace comfort
