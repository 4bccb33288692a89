// SPDX-License-Identifier: BSD-3-Clause
// Patches of sun: where the light of a sun falls that comes in through a window.
#pragma once
#include <vector>
#include "flatten/flat_scene.h"
#include "flatten/host_tracer.h"

namespace sampling {

// A parallelogram, seen from one side: windows and patches alike.
struct Target {
    base::Vec3 centre, u, v;  // edges
    base::Vec3 out;           // unit normal, away from the side that it lights
    // of a polished one in the sun: its roughness, squared, and where the mirrored sun stands, from the side that it
    // lights
    float gloss2 = 0;
    base::Vec3 sun = {0, 0, 0};
};

// Those with the largest lit areas, at most `most`, on what sunlight through these windows meets first.
std::vector<Target> find_patches(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const std::vector<Target>& windows, size_t most);

}  // namespace sampling
