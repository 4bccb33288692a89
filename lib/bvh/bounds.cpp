// SPDX-License-Identifier: BSD-3-Clause
// See bounds.h.  Woop's test works in coordinates relative to the ray's origin and rounds there (kernels/bvh/woop.h);
// so boxes are padded by an ulp or two.
#include "bvh/bounds.h"

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "kernels/dialect/compat_host.h"

namespace bvh {
namespace {
#include "kernels/bvh/intersect.h"

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
void reach_beyond_edges(const float* q, Bounds& box) {
    const uint32_t axis = as_uint_(q[POLYGON_AXIS]);
    const float* n = q + POLYGON_NORMAL;
    const float slope = (std::fabs(n[0]) + std::fabs(n[1]) + std::fabs(n[2])) / std::fabs(n[axis]) - 1;
    for (uint32_t a = 0; a < 3; a++) {
        const float d = 2 * q[POLYGON_MARGIN] * (a == axis ? slope : 1);
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
    const float* q = in.shapes + SHAPE_FLOATS * k;
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
    const double c[3] = {q[1], q[2], q[3]};
    switch (as_uint_(q[SHAPE_KIND])) {
    case SHAPE_SPHERE: {
        const float along[3] = {0, 0, 0};  // a "disc" without normal reaches r everywhere
        disc(c, along, q[4]);
        break;
    }
    case SHAPE_CONE: {
        const double end[3] = {c[0] + double(q[4]) * q[7], c[1] + double(q[5]) * q[7], c[2] + double(q[6]) * q[7]};
        disc(c, q + 4, q[8]);
        disc(end, q + 4, q[9]);
        break;
    }
    case SHAPE_RING: disc(c, q + 4, q[8]); break;
    case SHAPE_POLYGON: {
        const uint32_t axis = as_uint_(q[5]), first = as_uint_(q[6]), count = as_uint_(q[7]);
        const int iu = axis == 0 ? 1 : 0, iv = axis == 2 ? 1 : 2;
        for (uint32_t i = 0; i < count; i++) {
            const float u = in.polygon_uv[size_t(first) + i], v = in.polygon_uv[size_t(first) + POLYGON_ROW(count) + i];
            float p[3];
            p[iu] = u;
            p[iv] = v;
            p[axis] = float((double(q[4]) - double(q[1 + iu]) * u - double(q[1 + iv]) * v) / q[1 + axis]);
            grow(bounds, p);
        }
        break;
    }
    default: base::fail("", "unknown kind of shape");
    }
    return bounds;
}

namespace {

Bounds instance_bounds(const float* q, const std::vector<Bounds>& trees) {
    const uint32_t tree = as_uint_(q[INSTANCE_TREE]);
    if (tree == 0 || tree >= trees.size()) base::fail("", "an instance of a tree that does not exist");
    const Bounds& local = trees[tree];
    Bounds bounds = empty_bounds();
    if (local.lo[0] > local.hi[0]) return bounds;
    double m[12];
    invert_affine(q + 1, m);
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
        const size_t shape = in.first_shape + (k - in.triangle_count);
        const float* q = in.shapes + SHAPE_FLOATS * shape;
        if (as_uint_(q[SHAPE_KIND]) == SHAPE_INSTANCE) return instance_bounds(q, trees);
        bounds = shape_bounds(in, shape);
        if (as_uint_(q[SHAPE_KIND]) == SHAPE_POLYGON) reach_beyond_edges(q, bounds);
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
