// SPDX-License-Identifier: BSD-3-Clause
// Paths with all that they meet and gather, for `ptrace -pixel`: the kernels of one path at a time, compiled once more
// with a recorder (RECORD_VERTEX of kernels/integrator/path.h).  The light of a path is the sum of its lights.
#pragma once
#include <array>
#include <vector>
#include "device/device.h"

namespace device {

using Rgb = std::array<double, 3>;

// Light that a path gathers at a vertex.
struct RecordedLight {
    enum class From { source, distant, surface, ambient, medium };
    From from;
    uint32_t which;  // number of an active source, or of a distant surface
    bool shared;     // of the suffix vertex: it arrives through the connections
    Rgb rgb;
};

struct RecordedVertex {
    uint32_t prim, inst, modifier;  // NO_HIT: the path has left the scene
    const char* lobe;               // along which the path goes on, or "passes"; empty: it ends
    bool is_emitter;
    uint32_t bounces;               // diffuse ones before it
    bool at_suffix, behind_suffix;  // it is the suffix vertex, or its light is this one's
    Rgb point;                      // in the world
    Rgb throughput;                 // from there to the eye, or to the suffix vertex
    std::vector<RecordedLight> lights;
};
using RecordedPath = std::vector<RecordedVertex>;

// A connection to the suffix vertex of a path: shared light of that path times `weight` arrives.
struct Connection {
    uint32_t path;
    Rgb weight;
};

struct RecordedPaths {
    std::vector<RecordedPath> paths;  // par.path_count
    std::vector<Connection> connections;
};

// The paths of a pass; connections of path `which`.  par.path_count: small, with path reuse REUSE_SQUARE.
RecordedPaths record_paths(const flatten::FlatScene& scene, const Params& par, uint32_t which);

}  // namespace device
