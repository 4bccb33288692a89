// SPDX-License-Identifier: BSD-3-Clause
// The frames of one picture, written where the options say.
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "film/accumulate.h"
#include "image/picture.h"
#include "options.h"
#include "report.h"
#include "render/control.h"
#include "render/progressive.h"
#include "render/setup.h"

// When the stream of a picture ends: an option that ends it belongs in ends_of().
struct Ends {
    int64_t first, last;        // frames, both included; last: Options::endless if it is not known before the first
    std::function<bool()> now;  // asked once with each frame: it is the last
};
Ends ends_of(const Options& opt, render::Control& control, const std::string& label);

// What draws frames from .. from + count - 1.
using DrawFrames = std::function<void(int64_t from, int64_t count, const render::GiveFrame& give)>;

// Frames from .. ends.last; picture: with the header that they have in common; samples: of a point in a frame.  Returns
// the frame that an edit keeps from being written; ends.last + 1: the picture has ended.
int64_t render_frames(const Options& opt, const Ends& ends, int64_t from, image::Picture& picture,
                      const DrawFrames& draw, uint32_t samples, const render::Control& control, Report& report,
                      const std::string& device);

// The header of a picture of view i: what its frames have in common.  plan: of that view; null for a dark hour, for
// which no scene is loaded.
image::Picture start_picture(const Options& opt, const Sky& sky, size_t i, const render::ViewPlan* plan);
void write_frame(const Options& opt, const image::Picture& frame, film::Accumulator& sum);
// -picture: the sum of its frames.
void write_sum(const Options& opt, const film::Accumulator& sum);

// The one frame of a picture in an hour without light.
void write_dark(const Options& opt, image::Picture& picture);
