// SPDX-License-Identifier: BSD-3-Clause
// Patches of sun: surfaces lit by a sun through a window.
#pragma once
#include <vector>
#include "flatten/flat_scene.h"
#include "flatten/host_tracer.h"

namespace sampling {

// A parallelogram with one active side: windows and patches alike.
struct Target {
    base::Vec3 centre, u, v;  // edges
    base::Vec3 out;           // unit normal, away from the side that it lights
    // of a polished one in the sun: its squared roughness, and the direction of the mirrored sun from the side that it
    // lights
    float gloss2 = 0;
    base::Vec3 sun = {0, 0, 0};
};

// At most `most` patches of largest lit area, on the first surfaces that sunlight through these windows hits.
std::vector<Target> find_patches(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const std::vector<Target>& windows, size_t most);

}  // namespace sampling
