// SPDX-License-Identifier: BSD-3-Clause
// What frame 0 holds by area in a view: small sources seen straight, and images of the sun.
#pragma once
#include "render/loaded_scene.h"
#include "render/splat_emitters.h"
#include "render/sun_images.h"

namespace render {

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
