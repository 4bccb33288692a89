// SPDX-License-Identifier: BSD-3-Clause
// Pictures of many hours from one set of paths (docs/decisions/0042).  A scene in many hours differs in its sky and sun
// alone: paths are traced once, and what they would get from skies and suns is kept as factors (hour_factors.h), which
// the light of each hour multiplies.  The frames of an hour have the mean of that hour rendered by itself; errors of
// the hours are alike, because the paths are.
#pragma once
#include <functional>
#include <string>
#include <vector>
#include "render/hour_skies.h"
#include "render/view_plan.h"

namespace render {

// Frame k of an hour, as GiveFrame; returns false to end.
using GiveHourFrame =
    std::function<bool(size_t hour, int64_t k, const std::vector<float>& rgb, const image::Moments& moments)>;

struct HoursWanted {
    int64_t first = 0, last = 16;  // frames, both included
    bool moments = true;
    std::function<void(const std::string& doing, double share)> tell;  // for people who wait
};

// Frames of each hour, one after another.  plan: of a scene whose sky stands for those of the hours (hours_sky_text()).
void render_hours(device::Device& device, const ViewPlan& plan, const std::vector<HourSky>& hours,
                  const HoursWanted& wanted, const GiveHourFrame& give);

// Empty, or why hours of this scene have to be rendered one by one.
std::string why_apart(const ViewPlan& plan);
// Of each hour, whether a smooth plane shows the eye its sun: an image that rays hardly find and that only a picture of
// one hour draws.
std::vector<bool> have_images(const ViewPlan& plan, const std::vector<HourSky>& hours);
// Names the paths that pictures of the hours have in common (SHARED_PATHS=), besides their seed.
std::string shared_paths(const ViewPlan& plan);
// What the fingerprint of an hour's frames has behind that of the plan.
std::string hour_part(const HourSky& hour);

}  // namespace render
