// SPDX-License-Identifier: BSD-3-Clause
// The suns of many hours, where the eye sees them straight, drawn into frame 0 by area (drawn_sources.h has those of
// one sky).
#pragma once
#include <vector>
#include "render/frame_zero.h"
#include "render/hour_skies.h"

namespace render {

// A pixel of an hour, per radiance of its sun.
struct DrawnSun {
    uint32_t pixel;
    float rgb[3];
    DrawnLight light;
};

// Does this view draw suns?  Else its rays find them.
bool draws_suns(const ViewPlan& plan);
// By sun of the tables of par's view.
std::vector<std::vector<DrawnSun>> draw_suns(device::Device& device, const ViewPlan& plan, const device::Params& par);
// Adds them to the frame 0 of an hour.
void add_drawn_suns(const std::vector<DrawnSun>& drawn, const HourSky& hour, FrameZero& zero);

}  // namespace render
