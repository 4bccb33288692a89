// SPDX-License-Identifier: BSD-3-Clause
// Small bright sources (the sun's disc is 1.4 pixels wide at 512) splatted into frame 0 by area, because few rays would
// hit them: points spread evenly over the source, each added to the pixel that it falls in.
#pragma once
#include <vector>
#include "device/device.h"
#include "flatten/host_tracer.h"
#include "view/view.h"

namespace render {

struct SplatList {
    std::vector<device::SplatRay> rays;
    std::vector<uint32_t> pixel;    // row from the top * nx + column, of each ray
    std::vector<float> right, up;   // of the ray from the pixel's centre, in pixels
    std::vector<uint32_t> sources;  // all that are drawn so
};
// The sources that are small in this view, and their rays.
SplatList list_splatted_emitters(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const view::View& view, int nx, int ny);

}  // namespace render
