// SPDX-License-Identifier: BSD-3-Clause
// The progressive loop: frames of a scene, view and size, on a device (paper Eq. 7 and its section on frame noise).
//   load_scene() -> plan_view() -> draw_frame_zero() -> pixel_moments()
//                              \-> learn() -> frames
// Each stage takes the values of those before it and changes none of them.
#pragma once
#include <functional>
#include <vector>
#include "render/view_plan.h"

namespace render {

// Receives frame k: 3 floats a pixel, row 0 = top, W/(sr m2), and with frame 0 the moments of the light within the
// pixels (image/picture.h), where they are wanted.  Returns false to end.
using GiveFrame = std::function<bool(int64_t k, const std::vector<float>& rgb, const image::Moments& moments)>;

// Frames first .. first + count - 1 of a picture, in order.  Frame k depends on (seed, k, pixel) alone.  Throws
// device::Cancelled where an edit waits.
void render_frames(device::Device& device, const ViewPlan& plan, int64_t first, int64_t count, bool moments,
                   const GiveFrame& give);

// Of a point, at least, in each frame.
uint32_t samples_per_frame(const ViewPlan& plan);

}  // namespace render
