// SPDX-License-Identifier: BSD-3-Clause
// Measures one picture.  A PictureAnalyzer keeps the quantities that depend on view and size only.
//   Ev = sum L w cos (paper Eq. 1), DGP (Eq. 2 with evalglare's constants), RAMMG (Eqs. 5, 6), TAL and CR (Eqs. 3, 4).
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>
#include "glare/pyramid.h"
#include "glare/region_pixels.h"
#include "glare/settings.h"
#include "glare/sources.h"
#include "glare/statistics.h"

namespace glare {

// Factories of another program's methods (lib/evalglare); empty: luxpipe's own.
struct Methods {
    std::function<std::unique_ptr<const ViewGeometry>(const view::View&, const std::string& place)> geometry;
    std::function<std::unique_ptr<SourceFinder>(const Geometry&, const Settings&)> finder;
};

struct Measurement : Photometry {
    // The same for sources of filled pixels (filled.h); null: not required, or the picture has no moments.
    std::shared_ptr<const Measurement> filled;
    long not_finite = 0, negative = 0;
    double rammg = 0;
    double task_lum = 0;  // reference luminance of the threshold: task area, else the mean
    double threshold = 0;
    // Ev and Edir with drawn sources at their place in the pixel; `ev` and `direct_lux` take its centre, as evalglare
    // does.
    double placed_ev = 0, placed_direct_lux = 0;
    double direct_lux = 0, background = 0, background0 = 0;  // background0: as with -q 0
    std::vector<GlareSource> sources;
    GlareTerms glare;  // the same, for the formulas (or every bright pixel)
    bool any_source = false;
    double dgp = 0;           // with the external Ev if there is one, corrected, at most 1
    double dgp_computed = 0;  // with the computed Ev, before corrections
    double eye_lux_used = 0;  // Ev used for `dgp`
    double mean_pos = 0, mean_pos2 = 0, median = 0, median_pos = 0, median_pos2 = 0;  // of L, L/P, L/P^2
    std::vector<RegionValues> region_values;
    std::optional<PixelStatistics> band, mask, zone1, zone2;
    Pgsv pgsv{0, 0, 0};
    std::optional<double> black_corners;  // percent, type v
};

class PictureAnalyzer {
public:
    // With `draw`, `regions` needs names only.
    PictureAnalyzer(const Settings& settings, const Requirements& requirements,
                    std::optional<image::MaskSet> regions = {}, image::DrawRegions draw = {}, Methods methods = {});
    // Replaces the regions; if they cannot be drawn, throws Error and keeps the previous ones.
    void set_regions(image::MaskSet regions, image::DrawRegions draw, const Requirements& requirements);
    // `view`: overrides the picture's own.  Overwrites the picture's pixels.
    Measurement measure(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    // The same in two steps: converts the picture to grey, with checks and warnings; then measures it.
    Luminance read(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    Measurement measure(Luminance& lum, const std::string& place);
    // Another image of the last view, on any thread: each thread has its own finder.  classification_image: decides
    // which pixels are bright.  Only -G and -I change the images.
    Measurement measure(Luminance& lum, Luminance& classification_image, SourceFinder& finder) const;
    std::unique_ptr<SourceFinder> make_finder() const;
    // Values of regions only.
    Measurement measure_regions(const Luminance& lum) const;
    const Settings& settings() const { return settings_; }
    const Requirements& requirements() const { return requirements_; }
    const Geometry& geometry() const { return *geometry_; }
    const SourceFinder& finder() const { return *finder_; }  // of the last picture

private:
    std::unique_ptr<SourceFinder> make_finder(const Geometry& geometry) const;
    std::vector<RegionPixels> lay(image::MaskSet& regions, const image::DrawRegions& draw,
                                  const std::string& place) const;
    void prepare(const view::View& view, const image::Picture& picture, const std::string& place);
    void find_position_index();
    void place_drawn_pixels(const image::Moments& moments);
    // What a sum over pixels gains where drawn sources are at their place: of all, or of pixels above a luminance.
    double gain_of_place(const Luminance& lum, const Luminance& classification_image, double above) const;
    void position_statistics(const Luminance& lum, Measurement& m) const;
    void glare(Luminance& lum, Luminance& classification_image, SourceFinder& finder, Measurement& m) const;
    Measurement measure_filled(const Luminance& lum, const Luminance& classification_image, SourceFinder& finder,
                               const Measurement& m) const;
    void pixel_sets(const Luminance& lum, SourceFinder& finder, Measurement& m) const;
    void background_and_dgp(const SourceFinder& finder, Measurement& m) const;
    void regions(const Luminance& lum, Measurement& m) const;

    Methods methods_;
    Settings settings_;
    Requirements requirements_;
    std::optional<image::MaskSet> regions_;
    image::DrawRegions draw_;
    std::vector<std::string> region_names_;
    std::unique_ptr<Geometry> geometry_;
    std::unique_ptr<SourceFinder> finder_;
    // Of the moments of the picture that was read last.
    image::Moments moments_;
    std::vector<DrawnPixel> drawn_pixels_;
    std::unique_ptr<const Geometry> placed_geometry_;  // null: no pixel is drawn in
    bool told_no_moments_ = false, told_irradiance_ = false;
    bool narrow_ = false;  // a narrow view without a warning so far
    std::unique_ptr<const Pyramid> pyramid_;
    std::vector<RegionPixels> region_pixels_;
    std::vector<float> position_index_;  // by pixel, if medians are required
    std::optional<std::vector<uint32_t>> mask_;
};

}  // namespace glare
