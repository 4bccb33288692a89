// SPDX-License-Identifier: BSD-3-Clause
// One picture in, its numbers out.  A PictureAnalyzer keeps what depends only on view and size from picture to picture.
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

// Another program's ways (lib/evalglare); empty: luxpipe's own.
struct Methods {
    std::function<std::unique_ptr<const ViewGeometry>(const view::View&, const std::string& place)> geometry;
    std::function<std::unique_ptr<SourceFinder>(const Geometry&, const Settings&)> finder;
};

struct Measurement : Photometry {
    // The same with sources by what fills their pixels (filled.h); null: not asked for, or the picture has no moments.
    std::shared_ptr<const Measurement> filled;
    long not_finite = 0, negative = 0;
    double rammg = 0;
    double task_lum = 0;  // reference luminance of the threshold: task area, else the mean
    double threshold = 0;
    double direct_lux = 0, background = 0, background0 = 0;  // background0: -q 0 whatever -q says
    std::vector<GlareSource> sources;
    GlareTerms glare;  // the same for the formulas (or every bright pixel)
    bool any_source = false;
    double dgp = 0;           // with the external Ev if there is one, corrected, at most 1
    double dgp_computed = 0;  // with the computed Ev, before corrections
    double eye_lux_used = 0;  // the Ev of `dgp`
    double mean_pos = 0, mean_pos2 = 0, median = 0, median_pos = 0, median_pos2 = 0;  // of L, L/P, L/P^2
    std::vector<RegionValues> region_values;
    std::optional<PixelStatistics> band, mask, zone1, zone2;
    Pgsv pgsv{0, 0, 0};
    std::optional<double> black_corners;  // percent, type v
};

class PictureAnalyzer {
public:
    // With `draw`, `regions` need only have names.
    PictureAnalyzer(const Settings& settings, const Requirements& requirements,
                    std::optional<image::MaskSet> regions = {}, image::DrawRegions draw = {}, Methods methods = {});
    // Other regions from here on; throws Error, and keeps those it has, where they cannot be drawn.
    void set_regions(image::MaskSet regions, image::DrawRegions draw, const Requirements& requirements);
    // `view`: the one to use; without it the picture's own.  The picture's pixels are used up.
    Measurement measure(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    // The same in two steps: the grey picture over the picture's memory, checked and warned about; and what it
    // measures.
    Luminance read(image::Picture& picture, const std::string& place, const std::optional<view::View>& view = {});
    Measurement measure(Luminance& lum, const std::string& place);
    // Any other image of the view read last, on any thread: each thread has a finder of its own.
    // classification_image: which pixels are bright is decided there.  Both are changed by -G and -I alone.
    Measurement measure(Luminance& lum, Luminance& classification_image, SourceFinder& finder) const;
    std::unique_ptr<SourceFinder> make_finder() const;
    // Region values alone.
    Measurement measure_regions(const Luminance& lum) const;
    const Settings& settings() const { return settings_; }
    const Requirements& requirements() const { return requirements_; }
    const Geometry& geometry() const { return *geometry_; }
    const SourceFinder& finder() const { return *finder_; }  // of the picture measured last

private:
    std::vector<RegionPixels> lay(image::MaskSet& regions, const image::DrawRegions& draw,
                                  const std::string& place) const;
    void prepare(const view::View& view, const image::Picture& picture, const std::string& place);
    void find_position_index();
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
    bool told_no_moments_ = false;
    bool narrow_ = false;  // a narrow view, not yet warned of
    std::unique_ptr<const Pyramid> pyramid_;
    std::vector<RegionPixels> region_pixels_;
    std::vector<float> position_index_;  // by pixel, if medians are required
    std::optional<std::vector<uint32_t>> mask_;
};

}  // namespace glare
