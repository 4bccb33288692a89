// SPDX-License-Identifier: BSD-3-Clause
// The frames of one picture, written where the options say.
#pragma once
#include <cstdint>

#include "image/picture.h"
#include "options.h"
#include "render/control.h"
#include "render/progressive.h"

// Frames from .. opt.last of the renderer's view; picture: with the header that they have in common.  Returns the frame
// that an edit keeps from being written; opt.last + 1: the picture has ended.
int64_t render_frames(const Options& opt, int64_t from, image::Picture& picture, render::Renderer& renderer,
                      render::Control& control);
