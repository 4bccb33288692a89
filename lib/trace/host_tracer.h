// SPDX-License-Identifier: BSD-3-Clause
// Single rays on the host: which primitive a ray meets, whether a way is free, points on light sources.
// For set-up work and region queries; pictures go through Device.
#pragma once
#include <cstdint>
#include <memory>
#include "base/vec.h"
#include "trace/flat_scene.h"

namespace trace {

class HostTracer {
public:
    explicit HostTracer(const FlatScene& scene);  // keeps a reference
    ~HostTracer();
    // normal: the shape's own, wherever the ray comes from
    struct Found {
        double t;
        uint32_t prim;
        base::Vec3 normal;
    };
    enum Mask : uint32_t { opaque = 1, transparent = 2, all = 3 };
    // Nearest primitive along a ray given in world coordinates; t < 0 if none.
    Found closest(base::Vec3 origin, base::Vec3 dir, double tmin, double tmax, Mask mask) const;
    bool blocked(base::Vec3 origin, base::Vec3 dir, double tmin, double tmax, Mask mask) const;
    // A point of active source i seen from p (world), two numbers in [0,1): direction, distance (1e30 for distant ones)
    // and the solid angle it stands for (0: not seen from there).
    struct SourcePoint {
        base::Vec3 dir;
        double dist, solid_angle;
    };
    SourcePoint source_point(uint32_t i, base::Vec3 p, double x, double y) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

// The mean luminance of a light source, patterns included, over its points and the directions in which it shines;
// record: SOURCE_FLOATS of kernels/tables.h.
double mean_luminance(const FlatScene& scene, const float* record);

// Runs a .cal program of the scene's arenas for one point; false on a run-time error.  vars: CAL_VARS, out:
// CAL_OUTPUTS.
bool run_program(const FlatScene& scene, uint32_t entry, const float* vars, float* out);
struct RayVars {
    float values[64];
};
// The variables a program sees at point p (relative to scene.centre) for a ray of direction d on a surface of normal n.
RayVars ray_vars(const FlatScene& scene, base::Vec3 p, base::Vec3 d, base::Vec3 n);

}  // namespace trace
