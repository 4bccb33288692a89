// SPDX-License-Identifier: BSD-3-Clause
// Division of a picture's light: photometry, glare sources, background.  One interface for all three, because a
// background is the difference of two sums that must be added in the same order.
#pragma once
#include <memory>
#include <vector>
#include "glare/connected_components.h"
#include "glare/photometry.h"
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

class SourceFinder {
public:
    SourceFinder(const Geometry& geometry, const Settings& settings);
    virtual ~SourceFinder() = default;

    virtual Photometry photometry(const Luminance& lum) const { return glare::photometry(lum, geometry_); }
    // Reference luminance of the threshold: the mean of the task area (-t), or of the picture.
    virtual double reference_luminance(const Luminance& lum, double mean_lum) const;
    // Groups of bright pixels.  `classification_image` decides which pixels are bright and which are peaks.
    virtual void find_groups(const Luminance& lum, const Luminance& classification_image, double threshold) = 0;
    // The sources, one for each group, split at the borders of zones (-l, -L).
    virtual std::vector<GlareSource> split(const Luminance& lum) = 0;
    // Statistics of a band, a mask or a zone; must be called between find_groups() and split().
    virtual PixelStatistics statistics(const std::vector<uint32_t>& pixels, const Luminance& lum) const;
    virtual void mark_band(const std::vector<uint32_t>&) {}
    // Returns true if the sources are the whole light, except for rounding.
    virtual bool nothing_left(double rest, double whole) const { return rest < 1e-11 * whole; }

    const std::vector<Run>& runs() const { return runs_; }  // source pixels of the last picture, groups from 1
    const std::vector<Run>& runs_before_zones() const { return settings_.zones ? runs_before_zones_ : runs_; }
    const std::vector<GlareSource>& sources_before_zones() const { return sources_before_zones_; }
    double direct_lux() const { return direct_lux_; }

protected:
    // A pixel of a group.
    struct GroupPixel {
        uint32_t column_key, pixel, group;
    };
    // All pixels of runs(), columns from the left, in a column from the bottom: evalglare's order.
    std::vector<GroupPixel> column_order() const;
    bool searches() const { return radius_px_ >= 1; }  // the search radius is at least a pixel

    const Geometry& geometry_;
    const Settings& settings_;
    double radius_px_;
    std::vector<Run> runs_, runs_before_zones_;
    std::vector<GlareSource> sources_before_zones_;  // for evalglare's lines
    double direct_lux_ = 0;
};

// Connected components of bright pixels, smoothed (-s), without their peaks (-y); or fixed patches (-z).
class ConnectedSources final : public SourceFinder {
public:
    ConnectedSources(const Geometry& geometry, const Settings& settings);
    void find_groups(const Luminance& lum, const Luminance& classification_image, double threshold) override;
    std::vector<GlareSource> split(const Luminance& lum) override;

private:
    double light_of_groups(const Luminance& lum) const;
    void smooth();
    void extract_peaks(const Luminance& lum);
    void split_zones();

    ConnectedComponents components_;
    std::vector<Run> extra_;          // pixels that smoothing adds to a second group
    std::vector<int> zone_of_group_;  // by group number; empty without zones
    uint32_t groups_ = 0;             // highest number used
};

GlareTerms terms_of(const std::vector<GlareSource>& sources);
// Sums of the formulas: over the sources, or with DgpForm::pixel over every bright pixel.
GlareTerms glare_terms(const Luminance& lum, const Luminance& classification_image, const Geometry& geometry,
                       const Settings& settings, double threshold, const std::vector<GlareSource>& sources);

// -z: group of every pixel on evalglare's staggered grid of patches; returns the number of patches.
uint32_t assign_patches(std::vector<Run>& runs, const Geometry& geometry, const Patches& patches);

}  // namespace glare
