// SPDX-License-Identifier: BSD-3-Clause
// What frame 0 holds by area in a view: small sources seen straight, and images of the sun.
#pragma once
#include "render/splat_emitters.h"
#include "render/sun_images.h"

namespace render {

class DrawnSources {
public:
    DrawnSources() = default;
    // Finds them and writes the marks and discs into the tables of the scene and its device.  base: with the view; gets
    // the list of images.  straight, images: whether this view may have such.
    void select(device::Device& device, flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                const sampling::SmoothSurfaces& smooth, const view::View& view, bool straight, bool images,
                kernels::Params& base);
    const SplatList& straight() const { return straight_; }
    std::vector<ImagePoint> draw_images(device::Device& device, const kernels::Params& base) const {
        return render::draw_images(device, base, view_, images_);
    }

private:
    void mark(device::Device& device, flatten::FlatScene& scene) const;
    void write_discs(device::Device& device, flatten::FlatScene& scene, kernels::Params& base) const;

    view::View view_;
    SplatList straight_;
    SunImages images_;
};

}  // namespace render
