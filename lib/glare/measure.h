// SPDX-License-Identifier: BSD-3-Clause
// Measures one picture.  A PictureAnalyzer keeps the quantities that depend on view and size only.
//   Ev = sum L w cos (paper Eq. 1), DGP (Eq. 2 with evalglare's constants), RAMMG (Eqs. 5, 6), TAL and CR (Eqs. 3, 4).
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>
#include "glare/photometry.h"
#include "glare/pyramid.h"
#include "glare/region_pixels.h"
#include "glare/settings.h"
#include "glare/sources.h"
#include "glare/statistics.h"

namespace glare {

// How a program looks at pictures: luxpipe, or another one whose digits count (lib/evalglare).
using FindSources = std::function<Sources(const Luminance&, const Luminance& classification_image, const Geometry&,
                                          double threshold, const PixelSets&)>;
struct Methods {
    std::function<std::unique_ptr<const ViewGeometry>(const view::View&, const std::string& place)> geometry;
    std::function<Photometry(const Luminance&, const Geometry&, const Settings&)> photometry;
    // Of the threshold: the mean of the task area (-t), or of the picture.
    std::function<double(const Luminance&, const Geometry&, const Settings&, double mean_lum)> reference_luminance;
    // Finds them in pictures of a view and size; the geometry is that one, or one of the same directions.
    std::function<FindSources(const Geometry&, const Settings&)> sources;
    std::function<bool(double rest, double whole)> nothing_left;  // the sources are the whole light, but for rounding
};
Methods own_methods();

// What a picture's light gives that is divided into sources and the rest: of whole pixels, as evalglare has it, or of
// filled ones.  A formula of this alone has a meaning for both (columns.cpp).
struct Glare : Photometry {
    double task_lum = 0;  // reference luminance of the threshold: task area, else the mean
    double threshold = 0;
    double direct_lux = 0, background = 0, background0 = 0;  // background0: as with -q 0
    std::vector<GlareSource> sources;
    GlareTerms glare;  // the same, for the formulas (or every bright pixel)
    bool any_source = false;
    double dgp = 0;           // with the external Ev if there is one, corrected, at most 1
    double dgp_computed = 0;  // with the computed Ev, before corrections
    double eye_lux_used = 0;  // Ev used for `dgp`
};

struct Measurement : Glare, SetStatistics {
    std::optional<Glare> filled;  // by filled pixels (filled.h); none: not required, or the picture has no moments
    // Ev and Edir with drawn sources at their place in the pixel; `ev` and `direct_lux` take its centre, as evalglare
    // does.
    double placed_ev = 0, placed_direct_lux = 0;
    long not_finite = 0, negative = 0;
    double rammg = 0;
    double mean_pos = 0, mean_pos2 = 0, median = 0, median_pos = 0, median_pos2 = 0;  // of L, L/P, L/P^2
    std::vector<RegionValues> region_values;
    Pgsv pgsv{0, 0, 0};
    std::optional<double> black_corners;       // percent, type v
    std::vector<Run> runs, runs_before_zones;  // pixels of sources (sources.h)
    std::vector<GlareSource> sources_before_zones;
};

class PictureAnalyzer {
public:
    // With `draw`, `regions` needs names only.
    PictureAnalyzer(const Settings& settings, Requirements requirements, std::optional<image::MaskSet> regions = {},
                    image::DrawRegions draw = {}, Methods methods = own_methods());
    // Replaces the regions; if they cannot be drawn, throws Error and keeps the previous ones.
    void set_regions(image::MaskSet regions, image::DrawRegions draw, Requirements requirements);
    // `view`: overrides the picture's own.  Overwrites the picture's pixels.
    Measurement measure(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    // The same in two steps: converts the picture to grey, with checks and warnings; then measures it.
    Luminance read(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    Measurement measure(Luminance& lum, const std::string& place);
    // Another image of the last view, on any thread.  classification_image: decides which pixels are bright.  Only -G
    // and -I change the images.
    Measurement measure(Luminance& lum, Luminance& classification_image) const;
    // Values of regions only.
    Measurement measure_regions(const Luminance& lum) const;
    const Settings& settings() const { return settings_; }
    bool requires_sources() const { return requirements_ & require::sources; }
    const Geometry& geometry() const { return *geometry_; }

private:
    std::vector<RegionPixels> lay(image::MaskSet& regions, const image::DrawRegions& draw,
                                  const std::string& place) const;
    void prepare(const view::View& view, const image::Picture& picture, const std::string& place);
    void find_position_index();
    void place_drawn_pixels(const image::Moments& moments);
    // What a sum over pixels gains where drawn sources are at their place: of all, or of pixels above a luminance.
    double gain_of_place(const Luminance& lum, const Luminance& classification_image, double above) const;
    void position_statistics(const Luminance& lum, Measurement& m) const;
    PixelSets pixel_sets() const;
    void glare(Luminance& lum, Luminance& classification_image, Measurement& m) const;
    Glare filled_glare(const Luminance& lum, const Luminance& classification_image, const Measurement& m) const;
    void regions(const Luminance& lum, Measurement& m) const;

    Methods methods_;
    Settings settings_;
    Requirements requirements_;
    std::optional<image::MaskSet> regions_;
    image::DrawRegions draw_;
    std::vector<std::string> region_names_;
    std::unique_ptr<Geometry> geometry_;
    // Of the moments of the picture that was read last.
    image::Moments moments_;
    std::vector<DrawnPixel> drawn_pixels_;
    std::unique_ptr<const Geometry> placed_geometry_;  // null: no pixel is drawn in
    bool told_no_moments_ = false, told_irradiance_ = false;
    bool narrow_ = false;  // a narrow view without a warning so far
    std::unique_ptr<const Pyramid> pyramid_;
    std::vector<RegionPixels> region_pixels_;
    std::vector<float> position_index_;  // by pixel, if medians are required
    PixelSets sets_;
    FindSources find_sources_;
};

}  // namespace glare
