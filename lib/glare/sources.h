// SPDX-License-Identifier: BSD-3-Clause
// From bright pixels to glare sources, in evalglare's order: connect, smooth (-s), extract peaks (-y),
// split at zones (-l, -L); or fixed patches (-z) in place of connecting.  One GlareSource per group that kept pixels.
#pragma once
#include <memory>
#include <optional>
#include <vector>
#include "glare/check_picture.h"
#include "glare/connect.h"
#include "glare/evalglare_groups.h"
#include "glare/settings.h"

namespace glare {

struct GlareSource {
    double pixels = 0, omega = 0, lum = 0;  // omega-weighted mean luminance
    double x = 0, y = 0;                    // mean of the pixels weighted by L w; y from the bottom
    double brightest = 0;
    double eye_lux = 0;  // its share of the direct illuminance: sum L w cos
    int zone = 0;
    uint32_t group = 0;                          // evalglare's number, from 1
    double P = 1, sigma_deg = 0, theta_deg = 0;  // theta: sigma, but for a slip of evalglare's
    Vec3 direction;                              // of the pixel the centre falls into
};

class SourceFinder {
public:
    SourceFinder(const Geometry& geometry, const Settings& settings);
    std::vector<GlareSource> find(const Luminance& lum, double threshold);
    // The same in two steps: groups, painted in the check picture; and what they are after zones have split them.
    // Which pixels are bright, and which are peaks, is decided in `bright_in`.
    void find_groups(const Luminance& lum, const Luminance& bright_in, double threshold);
    std::vector<GlareSource> split(const Luminance& lum);
    // The source pixels found last as they are in another picture: sources, and light at the eye.
    std::vector<GlareSource> sums(const Luminance& lum) const;
    double light_of_groups(const Luminance& lum) const;
    void paint_band(const std::vector<uint32_t>& pixels);
    const CheckPicture* check_picture() const { return check_ ? &*check_ : nullptr; }  // with -c
    const std::vector<Run>& runs() const { return runs_; }  // the last picture's source pixels, groups from 1
    double direct_lux() const { return direct_lux_; }
    const std::vector<GlareSource>& before_zones() const { return before_zones_; }  // empty without zones
    // DgpForm::pixel
    std::vector<GlareTerm> every_pixel(const Luminance& lum, const Luminance& bright_in, double threshold) const;

private:
    void connect_as_evalglare();
    void paint_task();
    void paint_sources();
    void smooth();
    void extract_peaks(const Luminance& lum);
    void split_zones(const Luminance& lum);
    void paint_zones(const Vec3& centre, double inner, double outer);  // cosines

    const Geometry& geometry_;
    const Settings& settings_;
    double radius_px_;
    Connector connector_;
    std::vector<Run> runs_, extra_;                  // extra: pixels that smoothing counts in a second group
    std::vector<int> zone_of_group_;                 // by group number, empty without zones
    std::vector<double> slipped_eye_lux_;            // by group number, evalglare's after zones; else empty
    std::unique_ptr<EvalglareGroups> as_evalglare_;  // with settings.slips
    std::optional<CheckPicture> check_;              // likewise, or with -c
    std::vector<GlareSource> before_zones_;
    uint32_t groups_ = 0;  // highest number in use
    double direct_lux_ = 0;
};

// Where a source's centre is, and what follows from that: the pixel there, or the place inside of it.
void place(GlareSource& source, const Geometry& geometry, const Settings& settings, bool inside_pixel);

GlareTerms terms_of(const std::vector<GlareSource>& sources);
// What the formulas need: of the sources that were found, or with DgpForm::pixel of every bright pixel.
GlareTerms glare_terms(const SourceFinder& finder, const Luminance& lum, const Luminance& bright_in,
                       const Settings& settings, double threshold, const std::vector<GlareSource>& sources);

// -z: group of every pixel on evalglare's staggered grid of patches; returns the number of patches.
uint32_t assign_patches(std::vector<Run>& runs, const Geometry& geometry, const Patches& patches);

}  // namespace glare
