// SPDX-License-Identifier: BSD-3-Clause
// A picture of a scene, before its first sample: what its frames depend on.
#pragma once
#include <memory>
#include <string>
#include "render/drawn_sources.h"
#include "render/focus.h"
#include "render/point_rays.h"
#include "render/samples.h"
#include "view/view.h"

namespace render {

// A picture of the scene.  Its frames have the same bits whatever other pictures are rendered.
struct RenderView {
    view::View view;
    int nx = 0, ny = 0;
    Focus focus = {};
    std::shared_ptr<const PointList> points = {};  // in place of the view
};

// For the origin of the scene's tables: the eye, or the middle of most points.
flatten::Viewpoint viewpoint_of(const RenderView& v);

// Throws Error (system) if this machine cannot hold its frames.
void require_memory(const RenderView& v);

struct ViewPlan {
    LoadedScene scene;
    view::View view;
    int nx = 0, ny = 0;      // of the picture
    PixelSampling sampling;  // with the focus; diffuse directions by the cosine alone
    bool may_draw = false;   // its options let sources be drawn by area
    DrawnSources drawn;
    PointLayout points;            // of a picture of points; else empty
    size_t points_room = 0;        // pixels of that picture; 0: of a view
    uint32_t m = 0;                // frames that frame 0 stands for (Eq. 7)
    uint32_t samples_of_zero = 0;  // of the direct class, of each pixel in frame 0
    double noisy_share = 0;        // samples of noisy pixels over those of the picture; 0: none are sought
    bool tell_limit = false;       // warn of what -ab leaves out (beyond_limit.h)
    std::string fingerprint;       // fingerprint.h, with the device where its bits are its own
};

// Throws device::Cancelled where an edit waits: a plan is whole.
ViewPlan plan_view(device::Device& device, const LoadedScene& scene, const RenderView& v, const RenderOptions& o);

}  // namespace render
