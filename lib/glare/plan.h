// SPDX-License-Identifier: BSD-3-Clause
// A plan states what is measured in each picture of a run.  It does not change: an edit of the regions gives another
// one.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include "glare/photometry.h"
#include "glare/settings.h"
#include "glare/sources.h"
#include "image/masks.h"

namespace glare {

// The functions by which a program measures pictures: luxpipe, or another one whose digits are repeated
// (lib/evalglare).
using FindSources = std::function<Sources(const Luminance&, const Luminance& classification_image, const Geometry&,
                                          double threshold, const PixelSets&)>;
struct Methods {
    std::function<std::unique_ptr<const ViewGeometry>(const view::View&, const std::string& place)> geometry;
    std::function<Photometry(const Luminance&, const Geometry&, const Settings&)> photometry;
    // Reference luminance of the threshold: the mean of the task area (-t), or of the picture.
    std::function<double(const Luminance&, const Geometry&, const Settings&, double mean_lum)> reference_luminance;
    // Finds them in pictures of a view and size; the geometry is that one, or one of the same directions.
    std::function<FindSources(const Geometry&, const Settings&)> sources;
    std::function<bool(double rest, double whole)> nothing_left;  // the sources are the whole light, but for rounding
};
Methods own_methods();

struct Plan {
    Settings settings = {};
    Requirements requirements = 0;
    std::optional<image::MaskSet> regions = {};  // with `draw`: their names alone
    image::DrawRegions draw = {};
    Methods methods = own_methods();
};
using SharedPlan = std::shared_ptr<const Plan>;

SharedPlan make_plan(Plan plan);  // throws Error where the region of -task is not there

}  // namespace glare
