// SPDX-License-Identifier: BSD-3-Clause
// Single rays on the host: the nearest primitive, occlusion, points on light sources.  For work before the first frame;
// pictures go through Device.
#pragma once
#include <cstdint>
#include <memory>
#include "base/vec.h"
#include "flatten/flat_scene.h"

namespace flatten {

class HostTracer {
public:
    explicit HostTracer(const FlatScene& scene);  // keeps a reference
    ~HostTracer();
    // normal: the shape's own, whatever the direction of the ray; inst: as Hit.inst of the kernels; place: the point,
    // moved onto the surface; rounding: Surface.rounding
    struct Found {
        double t;
        uint32_t prim, inst;
        base::Vec3 normal, place;
        double rounding;
    };
    enum Mask : uint32_t { opaque = 1, transparent = 2, all = 3 };
    // Nearest primitive along a ray given in world coordinates; t < 0 if none.
    Found closest(base::Vec3 origin, base::Vec3 dir, double tmin, double tmax, Mask mask) const;
    bool blocked(base::Vec3 origin, base::Vec3 dir, double tmin, double tmax, Mask mask) const;
    // A point of active source i seen from p (world), from two numbers in [0,1): direction, distance (1e30 for distant
    // sources) and the solid angle that it represents (0: invisible from p).
    struct SourcePoint {
        base::Vec3 dir;
        double dist, solid_angle;
    };
    SourcePoint source_point(uint32_t i, base::Vec3 p, double x, double y) const;

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace flatten
