// SPDX-License-Identifier: BSD-3-Clause
// Surfaces as primitives, triangles and analytic shapes; and what of them concerns sources.
#pragma once
#include <cmath>
#include <cstdint>
#include <vector>
#include "base/vec.h"
#include "flatten/modifiers.h"
#include "scene/mesh.h"

namespace flatten {

class Instances;

// A rectangle about a mirror or prism, relative to the centre (APERTURE_* of kernels/tables.h).
struct Aperture {
    base::Vec3 centre, normal, u, v;
    bool both_sides;
};

// Emitters that the geometry finds.
struct Lights {
    struct Emitter {
        uint32_t object, prim;  // NONE: a mesh or an instance
    };
    std::vector<Emitter> emitters;

    // Flat mirrors and prisms, relative to the centre.
    struct Relay {
        uint32_t prim;
        base::Vec3 normal, centre;
        int exits;  // of a prism; 0: a mirror
        uint32_t material, object;
        double reflectance;
        Aperture aperture;
    };
    std::vector<Relay> relays;
};

// All trees: the scene's own, with the places of its instances, then what these hold.
// eye: for the origin of the tables (centre_of).
void flatten_geometry(const Modifiers& modifiers, const Instances& instances, const Viewpoint* eye,
                      const base::WorkBudget& work, Draft& out, Lights& lights);

// The surfaces of one scene, its meshes and instances left out, as part of the current tree with the origin `centre`.
// modifiers: null if those of an instance replace them all.  lights: null inside an instance, where nothing may be a
// source, a relay or a window.
void flatten_surfaces(const scene::Scene& scene, const Modifiers* modifiers, base::Vec3 centre,
                      const base::WorkBudget& work, Draft& out, Lights* lights);

// A mesh as the current tree.  materials: of an .obj, objects of modifiers->scene by the mesh's own numbers.
void flatten_mesh(const scene::Mesh& mesh, const Modifiers* modifiers, const std::vector<int32_t>& materials,
                  base::Vec3 centre, Draft& out);

// Number of the objects up to the last surface that is not a distant source.
size_t surfaces_end(const scene::Scene& scene);
void grow(Box& box, base::Vec3 p);
// Boxes of the surfaces of a scene, or of a mesh, a sample of them if they are many; `all` grows by each.
constexpr size_t MOST_BOXES = 65536;
std::vector<Box> surface_boxes(const scene::Scene& scene, Box& all);
std::vector<Box> surface_boxes(const scene::Mesh& mesh, Box& all);

// The length to which the rounding of a primitive is relative (kernels/bvh/offset_ray.h), as bits of Prim.kind: the
// power of two above it.
uint32_t extent_bits(double length);

// The plane of a flat primitive as kernels have it.
struct Plane {
    // corners: relative to the centre
    Plane(base::Vec3 normal, const base::Vec3* corners, size_t count);
    // The length to which the rounding of the fan of triangles of these corners is relative.
    double extent_of_triangles(const base::Vec3* corners, size_t count) const;

    float offset;      // n.p
    double deviation;  // of the corners
};

// Coordinates are floats in the end, and are squared: beyond this nothing can be said of a surface.
constexpr double farthest = 1e18;
inline bool within_reach(base::Vec3 p) {
    return std::fabs(p.x) < farthest && std::fabs(p.y) < farthest && std::fabs(p.z) < farthest;  // false for NaN
}

}  // namespace flatten
