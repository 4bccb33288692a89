// SPDX-License-Identifier: BSD-3-Clause
// Glare sources as evalglare finds them, to the last bit (-like evalglare): its scans, its order of sums, and the
// luminances that it reads back from the check picture it paints.
#pragma once
#include <optional>
#include "evalglare/check_picture.h"
#include "evalglare/groups.h"
#include "glare/measure.h"

namespace evalglare {

class SourceFinder final : public glare::SourceFinder {
public:
    SourceFinder(const glare::Geometry& geometry, const glare::Settings& settings, const Settings& own);
    glare::Photometry photometry(const glare::Luminance& lum) const override;
    double reference_luminance(const glare::Luminance& lum, double mean_lum) const override;
    void find_groups(const glare::Luminance& lum, const glare::Luminance& classification_image,
                     double threshold) override;
    std::vector<glare::GlareSource> split(const glare::Luminance& lum) override;
    glare::PixelStatistics statistics(const std::vector<uint32_t>& pixels, const glare::Luminance& lum) const override;
    void mark_band(const std::vector<uint32_t>& pixels) override;
    bool nothing_left(double rest, double) const override { return rest == 0; }

private:
    void connect(uint32_t patches);
    void smooth();
    double light_of_groups() const;
    void split_zones(const glare::Luminance& lum);
    std::vector<glare::GlareSource> sums(const glare::Luminance& lum) const;

    const Settings own_;
    Groups groups_;
    std::optional<CheckPicture> check_;
    std::vector<int> zone_of_group_;     // by group number, empty without zones
    std::vector<double> zoned_eye_lux_;  // by group number, after zones have split them; else empty
};

// Geometry and sources of evalglare, for a glare::PictureAnalyzer.
glare::Methods methods(const Settings& settings);

}  // namespace evalglare
