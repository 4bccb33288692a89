// SPDX-License-Identifier: BSD-3-Clause
// A picture as it is read: its luminances, and the tables of its view and size, which the next picture of the same view
// takes over.
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>
#include "glare/plan.h"
#include "glare/pyramid.h"
#include "glare/region_pixels.h"

namespace glare {

struct ViewTables {
    SharedPlan plan;
    std::shared_ptr<const Geometry> geometry;
    std::shared_ptr<const Pyramid> pyramid;  // null: RAMMG is not required
    std::vector<float> position_index;       // by pixel, if medians are required
    PixelSets sets;
    FindSources find_sources;
    std::vector<FindSources> find_by_other_reach;  // with require::reach: nearer, and farther
    std::vector<RegionPixels> regions;
};

struct Reading {
    std::shared_ptr<const ViewTables> tables;
    Luminance lum;  // in the picture's memory
    // Sources at the centroids that the moments of its pixels state.
    std::vector<DrawnPixel> drawn_pixels;
    std::shared_ptr<const Geometry> placed_geometry;  // null: no pixel is drawn in
    std::optional<double> black_corners;              // percent, type v
    // Of this picture or one before it.
    bool told_no_moments = false, told_irradiance = false, told_place = false;

    const Geometry& geometry() const { return *tables->geometry; }
    const Plan& plan() const { return *tables->plan; }
};

// `view`: overrides the picture's own.  Overwrites the picture's pixels.  before: the picture before this one.
Reading read(const SharedPlan& plan, image::Picture& picture, const std::string& place,
             const std::optional<view::View>& view = {}, Reading before = {});

}  // namespace glare
