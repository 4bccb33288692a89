// SPDX-License-Identifier: BSD-3-Clause
// From a scene's text to the plan of a picture, again and again as edits come (docs/decisions/0034-edits.md): what an
// edit leaves as it is, is taken over from the plan before.  A view or most options need nothing of the scene again,
// files all except the tree of unchanged surfaces.  After any edits the frames are those of a separate run.
#pragma once
#include "render/options.h"
#include "render/scene_text.h"
#include "render/view_plan.h"

namespace render {

// A picture, rendering options, and how files are read.
struct Setup {
    RenderView view;
    RenderOptions options;
    scene::ReadOptions reading;
};

// A preview: at most 128 pixels along its longer side, two direct samples, no noisy pixels or focus.
Setup preview_of(Setup setup);

// The tables of a scene with a text, for a picture and its options: those of `before` where they are the same.  Throws
// Error (unsupported input with file:line).
LoadedScene load(const device::Device& device, const SceneText& text, const Setup& setup,
                 const LoadedScene& before = {});

// The same with the picture's plan.  text: has been read for `before`, or since then.
ViewPlan plan_picture(device::Device& device, const SceneText& text, const Setup& setup, const ViewPlan& before = {});

}  // namespace render
