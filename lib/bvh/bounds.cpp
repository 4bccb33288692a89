// SPDX-License-Identifier: BSD-3-Clause
// See bounds.h.  Woop's test works in coordinates relative to the ray's origin and rounds there (kernels/bvh/woop.h);
// so boxes are padded by an ulp or two.
#include "bvh/bounds.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"

namespace bvh {
namespace {
using namespace kernels;

void pad(Bounds& box, float least) {
    float size = 0;  // of the largest coordinate: the distance to a large flat face rounds like its extent
    for (int a = 0; a < 3; a++) size = std::max({size, std::fabs(box.lo[a]), std::fabs(box.hi[a])});
    const float d = size * 2.4e-7f + least;
    for (int a = 0; a < 3; a++) {
        box.lo[a] -= d;
        box.hi[a] += d;
    }
}

// Points within a margin of a polygon's edges are inside.  Across its plane the box stays as thin as it was, so that
// rays that begin or end at the polygon do not enter it.
void reach_beyond_edges(const Shape& polygon, Bounds& box) {
    const float3 n = f3_of(polygon.normal);
    const uint32_t axis = polygon.dropped_axis;
    const float slope = (std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z)) / std::fabs(axis3(n, axis)) - 1;
    for (uint32_t a = 0; a < 3; a++) {
        const float d = 2 * polygon.margin * (a == axis ? slope : 1);
        box.lo[a] -= d;
        box.hi[a] += d;
    }
}

}  // namespace

Bounds empty_bounds() {
    const float inf = INFINITY;
    return {{inf, inf, inf}, {-inf, -inf, -inf}};
}

void grow(Bounds& bounds, const float p[3]) {
    for (int a = 0; a < 3; a++) {
        if (!(std::fabs(p[a]) < 1e18f)) base::fail("", "a coordinate is not a number or too large");
        bounds.lo[a] = std::min(bounds.lo[a], p[a]);
        bounds.hi[a] = std::max(bounds.hi[a], p[a]);
    }
}

Bounds shape_bounds(const Input& in, size_t k) {
    const Shape& shape = in.shapes[k];
    const float normal[3] = {shape.normal.x, shape.normal.y, shape.normal.z};
    Bounds bounds = empty_bounds();
    // A disc of radius r with normal n reaches r sqrt(1 - n_a^2) along axis a.
    const auto disc = [&](const double c[3], const float n[3], double r) {
        float lo[3], hi[3];
        for (int a = 0; a < 3; a++) {
            const double d = r * std::sqrt(std::max(0.0, 1.0 - double(n[a]) * n[a]));
            lo[a] = float(c[a] - d);
            hi[a] = float(c[a] + d);
        }
        grow(bounds, lo);
        grow(bounds, hi);
    };
    const double c[3] = {shape.centre.x, shape.centre.y, shape.centre.z};
    switch (shape.kind) {
    case SHAPE_SPHERE: {
        const float along[3] = {0, 0, 0};  // a "disc" without normal reaches r everywhere
        disc(c, along, shape.radius);
        break;
    }
    case SHAPE_CONE: {
        double end[3];
        for (int a = 0; a < 3; a++) end[a] = c[a] + double(normal[a]) * shape.length;
        disc(c, normal, shape.radius);
        disc(end, normal, shape.other_radius);
        break;
    }
    case SHAPE_RING: disc(c, normal, shape.radius); break;
    case SHAPE_POLYGON: {
        const uint32_t axis = shape.dropped_axis;
        const int iu = axis == 0 ? 1 : 0, iv = axis == 2 ? 1 : 2;
        const float *us = in.polygon_uv + shape.uv_at, *vs = us + POLYGON_ROW(shape.corners);
        for (uint32_t i = 0; i < shape.corners; i++) {
            const float u = us[i], v = vs[i];
            float p[3];
            p[iu] = u;
            p[iv] = v;
            p[axis] = float((double(shape.offset) - double(normal[iu]) * u - double(normal[iv]) * v) / normal[axis]);
            grow(bounds, p);
        }
        break;
    }
    default: base::fail("", "unknown kind of shape");
    }
    return bounds;
}

namespace {

Bounds instance_bounds(const Instance& instance, const std::vector<Bounds>& trees) {
    const uint32_t tree = instance.tree;
    if (tree == 0 || tree >= trees.size()) base::fail("", "an instance of a tree that does not exist");
    const Bounds& local = trees[tree];
    Bounds bounds = empty_bounds();
    if (local.lo[0] > local.hi[0]) return bounds;
    double m[12];
    invert_affine(instance.to_tree, m);
    for (int corner = 0; corner < 8; corner++) {
        float p[3];
        for (int a = 0; a < 3; a++) {
            double x = m[4 * a + 3];
            for (int b = 0; b < 3; b++) x += m[4 * a + b] * (corner >> b & 1 ? local.hi[b] : local.lo[b]);
            p[a] = float(x);
        }
        grow(bounds, p);
    }
    const float size =
        std::max({bounds.hi[0] - bounds.lo[0], bounds.hi[1] - bounds.lo[1], bounds.hi[2] - bounds.lo[2]});
    pad(bounds, 1e-6f * size);
    return bounds;
}

}  // namespace

Bounds primitive_bounds(const Input& in, size_t k, const std::vector<Bounds>& trees) {
    Bounds bounds = empty_bounds();
    if (k < in.triangle_count) {
        for (int i = 0; i < 3; i++) {
            const uint32_t v = in.triangles[3 * k + i];
            grow(bounds, in.vertices + 3 * size_t(v));
        }
        pad(bounds, 1e-30f);
    } else {
        if (k >= in.first_instance()) return instance_bounds(in.instances[k - in.first_instance()], trees);
        const size_t shape = in.first_shape + (k - in.triangle_count);
        bounds = shape_bounds(in, shape);
        if (in.shapes[shape].kind == SHAPE_POLYGON) reach_beyond_edges(in.shapes[shape], bounds);
        pad(bounds, 1e-30f);
    }
    return bounds;
}

void invert_affine(const float m[12], double out[12]) {
    double c[9];  // cofactors, transposed
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int a = (j + 1) % 3, b = (j + 2) % 3, d = (i + 1) % 3, e = (i + 2) % 3;
            c[3 * i + j] = double(m[4 * a + d]) * m[4 * b + e] - double(m[4 * a + e]) * m[4 * b + d];
        }
    }
    const double det = m[0] * c[0] + m[1] * c[3] + m[2] * c[6];
    if (det == 0) base::fail("", "the transform of an instance cannot be inverted");
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) out[4 * i + j] = c[3 * i + j] / det;
        out[4 * i + 3] = m[4 * i + 3];
    }
}

}  // namespace bvh
