// SPDX-License-Identifier: BSD-3-Clause
// A block of hours makes pictures of factors (hour_factors.h).  Values of a block stand side by side: those of value i
// of a picture at i * hours to i * hours + hours - 1.
#pragma once
#include <vector>
#include "render/hour_factors.h"
#include "render/hour_skies.h"

namespace render {

using HourValues = std::vector<float>;

// Adds by * from to n values.
void add_scaled(float* to, const float* from, float by, size_t n);
// The same values hour by hour: one hour after another.
HourValues hour_by_hour(const HourValues& block, size_t hours);
// One hour of these.
std::vector<float> values_of_hour(const HourValues& by_hour, size_t hours, size_t hour);

class HourLight {
public:
    // Hours first .. first + count - 1.  drawn: what the eye sees of the suns straight is drawn by area, and not here.
    HourLight(const std::vector<HourSky>& hours, size_t first, size_t count, bool drawn);
    size_t hours() const { return sky_.size(); }
    const HourSky& hour(size_t i) const { return first_[i]; }
    bool drawn() const { return drawn_; }
    // Adds the light of a path: its own, or that of its suffix vertex, to 3 rows of hours.
    void add_own(const PathFactors& f, size_t path, float* to) const;
    void add_suffix(const PathFactors& f, size_t path, float* to) const;
    // Of its own light that of the suns alone, times `by`.
    void add_own_suns(const PathFactors& f, size_t path, float by, float* to) const { add_suns(f, 2 * path, by, to); }

private:
    void add_sky(const device::SkyShare& sky, float* to) const;
    void add_tinted(const device::SkyShare& sky, bool disc, const float* radiance, float* to) const;
    void add_suns(const PathFactors& f, size_t list, float by, float* to) const;

    size_t begin_;
    const HourSky* first_;
    SkyBlock sky_;
    bool drawn_;
};

// The mean of the paths of each pixel, with path reuse; 3 rows a pixel.
HourValues light_frame(const PathFactors& f, size_t pixels, const HourLight& by);

// The samples of each pixel, which are of the direct class: their mean, half the difference of the means of both
// halves, and, a row a pixel, the variance of their grey.  A sun is asked by each `step`-th sample of a pixel;
// turn_of(pixel): sample k asks the suns of hours of (number + turn + k) % step = 0.
struct DirectValues {
    HourValues mean, half_off, spread;
};
DirectValues light_direct(const PathFactors& f, size_t first_pixel, const HourLight& by, uint32_t step,
                          const std::vector<uint32_t>& turn_of_pixel);

}  // namespace render
