// SPDX-License-Identifier: BSD-3-Clause
// Pictures of light by an action (docs/spectra.md): a few renderings, whose three colours are bands of wavelengths, in
// place of one.  Their sum is one number a pixel, in all three colours of a frame.
#pragma once
#include <array>
#include <string>
#include <vector>
#include "flatten/band_colours.h"
#include "render/hours.h"
#include "render/setup.h"
#include "spectrum/action.h"

namespace render {

// One of the renderings: the weights of its colours in the sum.
struct ActionPart {
    std::shared_ptr<const flatten::BandColours> colours;
    std::array<double, 3> weights;
};

// bands: a multiple of 3.
std::vector<ActionPart> parts_of(const spectrum::Action& action, int bands, const flatten::LightSpectra& lights);
// The same for light that is daylight of R = G = B = 1 in bands: hours of a weather file.
std::vector<ActionPart> parts_by_daylight(std::vector<ActionPart> parts);

// The same picture in bands.
Setup in_bands(Setup setup, const ActionPart& part);

// Adds a frame of a part to a grey one.
void add_part(const ActionPart& part, const std::vector<float>& rgb, std::vector<float>& grey);
// The same value in three colours.
std::vector<float> as_rgb(const std::vector<float>& grey);

// Frame k of an action: 3 floats a pixel.  Returns false to end.
using GiveSum = std::function<bool(int64_t k, const std::vector<float>& rgb)>;

// Frames first .. first + count - 1 of the plans of all parts.  Throws device::Cancelled where a signal came.
void render_action(device::Device& device, const std::vector<ActionPart>& parts, const std::vector<ViewPlan>& plans,
                   int64_t first, int64_t count, const GiveSum& give);

// The renderings of an action in hours that share their paths (hours.h).
struct ActionHours {
    image::Action label;
    std::vector<ActionPart> parts;  // by daylight
    std::vector<ViewPlan> plans;
};
// Frame k of an hour, of an action or, null, the ordinary one.  Returns false to end.
using GiveAnyFrame = std::function<bool(const ActionHours* action, size_t hour, int64_t k,
                                        const std::vector<float>& rgb, const image::Moments& moments)>;
// Hour by hour the ordinary frames of a plan, then those of each action.
void render_hours(device::Device& device, const ViewPlan& plan, const std::vector<HourSky>& hours,
                  const HoursWanted& wanted, const std::vector<ActionHours>& actions, const GiveAnyFrame& give);

// Of a sum: that of the first plan, with the scenes of all.
std::string action_fingerprint(const std::vector<ViewPlan>& plans);

}  // namespace render
