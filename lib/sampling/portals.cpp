// SPDX-License-Identifier: BSD-3-Clause
// Panes in one plane that lie close together become one portal.  Rays find its outer side, so the orientation of the
// glass does not matter: a portal must see clearly more of the sky on one side.  The largest portals are kept.
#include "sampling/portals.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "base/angle.h"
#include "flatten/host_tracer.h"
#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace sampling {
namespace {
using base::Vec3;
using flatten::packed;
using flatten::vec_of;

constexpr size_t MOST = 16;  // each costs a few operations per diffuse sample
constexpr size_t MOST_PATCHES = 8;
constexpr double SLIVER = 1e-6;  // of the largest window's area: smaller ones lose finite records
static_assert(MOST + MOST_PATCHES + MOST_HIGHLIGHTS <= MOST_PORTALS, "their lights have places in the parameters");
constexpr double NEAR_BY = 2;  // metres: typical distance to a narrow highlight
constexpr size_t MOST_PANES = 2000;
constexpr int RAYS_OUT = 256;   // per side
constexpr double ENOUGH = 0.1;  // least excess of rays that escape on the outer side over those on the inner side

struct Rect {
    Vec3 origin, u, v, n;  // unit axes, n = u x v
    double lo[2], hi[2];   // extent along u and v from origin
    double glass;          // pane area inside
    double area() const { return (hi[0] - lo[0]) * (hi[1] - lo[1]); }
};

Rect rect_of(const flatten::Geometry::Pane& p) {
    Rect r;
    r.origin = p.corner;
    r.u = unit(p.edge);
    r.n = p.normal;
    r.v = cross(r.n, r.u);
    r.glass = p.area;
    for (int k = 0; k < 2; k++) {
        r.lo[k] = 1e30;
        r.hi[k] = -1e30;
    }
    for (const Vec3& q : p.points) {
        const double c[2] = {dot(q - r.origin, r.u), dot(q - r.origin, r.v)};
        for (int k = 0; k < 2; k++) {
            r.lo[k] = std::min(r.lo[k], c[k]);
            r.hi[k] = std::max(r.hi[k], c[k]);
        }
    }
    return r;
}

// b's extent in a's axes, if they lie in one plane with aligned axes.
bool merge(Rect& a, const Rect& b) {
    if (std::fabs(dot(a.n, b.n)) < 0.9999) return false;
    if (std::fabs(dot(b.origin - a.origin, a.n)) > 0.05 * std::sqrt(std::max(a.area(), b.area()))) return false;
    Rect m = a;
    for (int i = 0; i < 4; i++) {
        const Vec3 q = b.origin + b.u * (i & 1 ? b.hi[0] : b.lo[0]) + b.v * (i & 2 ? b.hi[1] : b.lo[1]);
        const double c[2] = {dot(q - a.origin, a.u), dot(q - a.origin, a.v)};
        for (int k = 0; k < 2; k++) {
            m.lo[k] = std::min(m.lo[k], c[k]);
            m.hi[k] = std::max(m.hi[k], c[k]);
        }
    }
    m.glass = a.glass + b.glass;
    if (m.area() > 2 * m.glass) return false;
    a = m;
    return true;
}

void largest_first(std::vector<Rect>& rects, size_t most) {
    std::stable_sort(rects.begin(), rects.end(), [](const Rect& a, const Rect& b) { return a.area() > b.area(); });
    if (rects.size() > most) rects.resize(most);
}

// Panes, those of one window merged.
std::vector<Rect> windows_of(const std::vector<flatten::Geometry::Pane>& panes) {
    std::vector<Rect> rects;
    for (const flatten::Geometry::Pane& p : panes) rects.push_back(rect_of(p));
    largest_first(rects, MOST_PANES);
    for (bool again = true; again;) {
        again = false;
        for (size_t i = 0; i < rects.size(); i++)
            for (size_t j = i + 1; j < rects.size();)
                if (merge(rects[i], rects[j])) {
                    rects.erase(rects.begin() + long(j));
                    again = true;
                } else j++;
    }
    largest_first(rects, 4 * MOST);
    return rects;
}

// Fraction of the rays from the window, distributed by the cosine about n, that hit nothing opaque.
double open_share(const flatten::HostTracer& tracer, const Rect& r, Vec3 n, std::mt19937& random) {
    std::uniform_real_distribution<double> uniform(0, 1);
    const double off = 1e-4 * std::sqrt(r.area());
    double share = 0;
    for (int i = 0; i < RAYS_OUT; i++) {
        const double a = r.lo[0] + (r.hi[0] - r.lo[0]) * uniform(random);
        const double b = r.lo[1] + (r.hi[1] - r.lo[1]) * uniform(random);
        const double s = uniform(random), phi = 2 * base::pi * uniform(random);
        const Vec3 d =
            r.u * (std::sqrt(s) * std::cos(phi)) + r.v * (std::sqrt(s) * std::sin(phi)) + n * std::sqrt(1 - s);
        if (!tracer.blocked(r.origin + r.u * a + r.v * b + n * off, d, 0, 1e30, flatten::HostTracer::opaque))
            share += 1.0 / RAYS_OUT;
    }
    return share;
}

Target target_of(const Rect& r, Vec3 outdoors) {
    const Vec3 middle = r.u * ((r.lo[0] + r.hi[0]) / 2) + r.v * ((r.lo[1] + r.hi[1]) / 2);
    return {r.origin + middle, r.u * (r.hi[0] - r.lo[0]), r.v * (r.hi[1] - r.lo[1]), outdoors};
}

// Sunlit polished rectangles (sampling/highlights.h) so narrow that most directions in a cone about the mirrored sun
// would miss them: frames, sills, edges of tables.
std::vector<Target> glossy_reflectors(const flatten::FlatScene& scene) {
    std::vector<Target> targets;
    for (const kernels::Highlight& h : scene.highlights) {
        const Vec3 u = vec_of(h.u), v = vec_of(h.v);
        const double cone = NEAR_BY * std::sqrt(double(h.alpha2));
        if (!(std::min(length(u), length(v)) < cone)) continue;
        const Vec3 centre = scene.centre + vec_of(h.corner) + (u + v) * .5;
        targets.push_back({centre, u, v, -vec_of(h.normal), h.alpha2, vec_of(h.dir)});
    }
    return targets;
}

// What a portal knows of the sun that it mirrors, in the kernels' precision.
void set_mirrored(const Target& target, kernels::Portal& portal) {
    using namespace kernels;
    const float3 mirrored = f3_of(packed(target.sun)), out = f3_of(portal.normal);
    const float down = dot3(mirrored, out);
    const float3 sun = sub3(mirrored, scale3(out, 2.0f * down));
    const auto inverse = [](float x) { return 1.0f / (std::fabs(x) > 1e-12f ? x : 1e-12f); };
    portal.sun = {sun.x, sun.y, sun.z};
    portal.mirrored_out = down;
    portal.mirrored_u = dot3(mirrored, f3_of(portal.along_u));
    portal.mirrored_per_u = inverse(portal.mirrored_u);
    portal.mirrored_v = dot3(mirrored, f3_of(portal.along_v));
    portal.mirrored_per_v = inverse(portal.mirrored_v);
}

kernels::Portal portal_of(const Target& target, Vec3 origin) {
    const Vec3 across = cross(target.u, target.v);  // along u: by the vector across v with a component of 1 along u
    const double square = dot(across, across);
    kernels::Portal portal{};
    portal.centre = packed(target.centre - origin);
    portal.u = packed(target.u);
    portal.v = packed(target.v);
    portal.normal = packed(target.out);
    portal.along_u = packed(cross(target.v, across) * (1 / square));
    portal.along_v = packed(cross(across, target.u) * (1 / square));
    portal.area = float(std::sqrt(square));
    portal.gloss2 = target.gloss2;
    set_mirrored(target, portal);
    return portal;
}

}  // namespace

std::vector<Target> find_windows(const flatten::FlatScene& scene) {
    const std::vector<Rect> rects = windows_of(scene.geometry->panes);
    const flatten::HostTracer tracer(scene);
    std::mt19937 random(7);
    std::vector<Target> windows;
    for (const Rect& r : rects) {
        if (!(r.area() > SLIVER * rects.front().area())) break;  // largest first
        const double front = open_share(tracer, r, r.n, random), back = open_share(tracer, r, -r.n, random);
        if (std::fabs(front - back) < ENOUGH) continue;
        windows.push_back(target_of(r, back > front ? -r.n : r.n));
        if (windows.size() == MOST) break;
    }
    return windows;
}

void find_portals(flatten::FlatScene& scene, const std::vector<Target>& windows) {
    if (windows.empty()) return;
    const flatten::HostTracer tracer(scene);
    scene.window_count = uint32_t(windows.size());
    std::vector<Target> targets = windows;
    const std::vector<Target> patches = find_patches(scene, tracer, windows, MOST_PATCHES);
    targets.insert(targets.end(), patches.begin(), patches.end());
    if (!patches.empty()) {
        const std::vector<Target> reflectors = glossy_reflectors(scene);
        targets.insert(targets.end(), reflectors.begin(), reflectors.end());
    }
    for (const Target& target : targets) scene.portals.push_back(portal_of(target, scene.centre));
}

}  // namespace sampling
