// SPDX-License-Identifier: BSD-3-Clause
// What frame 0 holds by area in a view: small sources seen straight, and images of the sun.
#pragma once
#include "render/loaded_scene.h"
#include "render/sun_images.h"

namespace render {

// Rays to points of small bright sources, splatted into frame 0 by area.
struct SplatList {
    std::vector<device::SplatRay> rays;
    std::vector<uint32_t> pixel;    // row from the top * nx + column, of each ray
    std::vector<float> right, up;   // of the ray from the pixel's centre, in pixels
    std::vector<uint32_t> sources;  // all that are drawn so
};

struct DrawnSources {
    SplatList straight;
    SunImages images;
};

// Finds them.  par: of a pass, with the view; straight, images: whether this view may have such.
DrawnSources find_drawn_sources(device::Device& device, const LoadedScene& scene, const flatten::HostTracer& tracer,
                                const view::View& view, bool straight, bool images, const device::Params& par);

// As tables of the view.
kernels::ViewTables view_tables(const DrawnSources& drawn, const flatten::FlatScene& scene);

}  // namespace render
