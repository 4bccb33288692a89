// SPDX-License-Identifier: BSD-3-Clause
// Triangles of one rough polished material in one plane form a coplanar patch; rays from random points of it toward the
// sun find its lit part.  The patches whose lit part reflects most light into its highlight are kept.
#include "sampling/highlights.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "flatten/host_tracer.h"
#include "flatten/pack.h"
#include "sampling/suns.h"
#include "kernels/dialect/host.h"

namespace sampling {
namespace {
using namespace kernels;
using base::Vec3;

constexpr float LEAST_ROUGH = 1e-3f, MOST_ROUGH = .2f;  // rougher ones are sampled well enough by the cosine
constexpr float SUN_ALPHA2 = 1e-5f;                     // added to a squared roughness for the sun's disc
constexpr double LEAST_COSINE = .02;                    // between a patch's normal and the sun
constexpr size_t MOST_POLISHED = 64, MOST_KNOWN = 1024;
constexpr int RAYS = 256;  // from each patch
constexpr int LEAST_LIT = 3;
constexpr size_t TRIANGLES_A_CHECK = 1024;  // some milliseconds

struct CoplanarPatch {
    Vec3 p, n, sun;
    float alpha2;
    double specular, area = 0;
    std::vector<size_t> triangles;
    std::vector<double> upto;  // cumulative area of the triangles
    // its lit part, by rays
    double lit = 0, lo[2] = {1e30, 1e30}, hi[2] = {-1e30, -1e30};
    Vec3 u, v;
};

// Arguments of a primitive's material if it is a rough polished one, else null.
const float* glossy_args(const flatten::FlatScene& scene, uint32_t prim) {
    const Prim& record = scene.prims[prim];
    if ((record.kind & PRIM_KIND_MASK) != PRIM_FLAT) return nullptr;
    const uint32_t mod = flatten::material_record(scene, record.mod);
    if (mod == NONE) return nullptr;
    const Modifier& material = scene.modifiers[mod];
    if (material.type != M_PLASTIC && material.type != M_METAL && material.type != M_TRANS) return nullptr;
    const float* arg = &scene.f[material.args];
    return arg[3] > 0 && arg[4] > LEAST_ROUGH && arg[4] < MOST_ROUGH ? arg : nullptr;
}

class Search {
public:
    Search(const flatten::FlatScene& scene, const base::WorkBudget& work)
        : scene_(scene), work_(work), tracer_(scene) {}

    std::vector<CoplanarPatch> patches(const std::vector<Vec3>& suns) {
        const flatten::FlatScene::Tree& tree = scene_.trees.at(0);
        for (size_t t = tree.first_triangle; t < tree.first_triangle + tree.triangle_count; t++) {
            if (t % TRIANGLES_A_CHECK == 0) work_.check();
            for (const Vec3& sun : suns) add(t, sun);
        }
        largest_first(MOST_POLISHED, [](const CoplanarPatch& s) { return s.area * s.specular; });
        for (CoplanarPatch& patch : patches_) {
            // All lit, this patch and the smaller ones after it would reflect less.
            const auto more = [&](const CoplanarPatch& s) { return s.lit * s.specular >= patch.area * patch.specular; };
            if (std::count_if(patches_.begin(), patches_.end(), more) >= MOST_HIGHLIGHTS) break;
            light(patch);
        }
        patches_.erase(
            std::remove_if(patches_.begin(), patches_.end(), [](const CoplanarPatch& s) { return !(s.lit > 0); }),
            patches_.end());
        largest_first(MOST_HIGHLIGHTS, [](const CoplanarPatch& s) { return s.lit * s.specular; });
        return std::move(patches_);
    }

private:
    const flatten::FlatScene& scene_;
    const base::WorkBudget& work_;
    const flatten::HostTracer tracer_;
    std::vector<CoplanarPatch> patches_;
    std::map<int, std::vector<size_t>> facing_;  // patches by their normals, for scenes of millions of triangles

    // Key of directions within about a hundredth; walls, floors and slopes of whole percents lie well inside a cell.
    static int facing(Vec3 n) {
        const auto step = [](double x) { return int(std::floor(x * 99.7 + .5)) + 128; };
        return (step(n.x) * 256 + step(n.y)) * 256 + step(n.z);
    }

    template <class Key>
    void largest_first(size_t most, Key&& key) {
        std::stable_sort(patches_.begin(), patches_.end(),
                         [&](const CoplanarPatch& a, const CoplanarPatch& b) { return key(a) > key(b); });
        if (patches_.size() > most) patches_.resize(most);
    }

    Vec3 corner(size_t triangle, int k) const {
        const size_t vertex = scene_.trees[0].first_vertex + scene_.geometry->triangles[3 * triangle + size_t(k)];
        const float* at = &scene_.geometry->vertices[3 * vertex];
        return Vec3{at[0], at[1], at[2]} + scene_.centre;
    }

    void add(size_t triangle, Vec3 sun) {
        const uint32_t prim = scene_.geometry->tri_prim[triangle] & 0x7fffffffu;
        const float* arg = glossy_args(scene_, prim);
        if (arg == nullptr) return;
        Vec3 n = flatten::vec_of(scene_.prims[prim].normal);
        if (dot(n, sun) < 0) n = -n;
        if (dot(n, sun) < LEAST_COSINE) return;

        const Vec3 p = corner(triangle, 0);
        const double area = .5 * length(cross(corner(triangle, 1) - p, corner(triangle, 2) - p));
        const float alpha2 = arg[4] * arg[4] + SUN_ALPHA2;
        std::vector<size_t>& alike = facing_[facing(n)];
        CoplanarPatch* of = nullptr;
        for (size_t i : alike) {
            CoplanarPatch& patch = patches_[i];
            if (patch.alpha2 == alpha2 && dot(patch.n, n) > .99999 && dot(patch.sun, sun) > .99999 &&
                std::fabs(dot(p - patch.p, n)) < 1e-4 * (1 + length(p - patch.p)))
                of = &patch;
        }
        if (of == nullptr) {
            if (patches_.size() == MOST_KNOWN) return;
            alike.push_back(patches_.size());
            patches_.push_back({});
            of = &patches_.back();
            of->p = p;
            of->n = n;
            of->sun = sun;
            of->alpha2 = alpha2;
            of->specular = arg[3];
        }
        of->area += area;
        of->triangles.push_back(triangle);
        of->upto.push_back(of->area);
    }

    // Lit part: a rectangle around the points that see the sun, with a margin for the points between them.
    void light(CoplanarPatch& patch) {
        std::mt19937 random(7);
        std::uniform_real_distribution<double> uniform(0, 1);
        const size_t first = patch.triangles[0];
        patch.u = unit(corner(first, 1) - corner(first, 0));
        patch.v = cross(patch.n, patch.u);
        const double off = 1e-4 * std::sqrt(patch.area), margin = std::sqrt(patch.area / RAYS);
        int lit = 0;
        for (int i = 0; i < RAYS; i++) {
            const double at = uniform(random) * patch.area, x = std::sqrt(uniform(random)), y = uniform(random);
            const size_t k = size_t(std::upper_bound(patch.upto.begin(), patch.upto.end(), at) - patch.upto.begin());
            const size_t triangle = patch.triangles[std::min(k, patch.triangles.size() - 1)];
            const Vec3 p =
                corner(triangle, 0) * (1 - x) + corner(triangle, 1) * (x * (1 - y)) + corner(triangle, 2) * (x * y);
            if (tracer_.blocked(p + patch.n * off, patch.sun, 0, 1e30, flatten::HostTracer::opaque)) continue;
            const double place[2] = {dot(p - patch.p, patch.u), dot(p - patch.p, patch.v)};
            for (int axis = 0; axis < 2; axis++) {
                patch.lo[axis] = std::min(patch.lo[axis], place[axis] - margin);
                patch.hi[axis] = std::max(patch.hi[axis], place[axis] + margin);
            }
            lit++;
        }
        if (lit >= LEAST_LIT) patch.lit = patch.area * lit / RAYS;
    }
};

}  // namespace

void find_highlights(flatten::FlatScene& scene, const base::WorkBudget& work) {
    const std::vector<Vec3> suns = suns_of(scene);
    if (suns.empty()) return;
    for (const CoplanarPatch& patch : Search(scene, work).patches(suns)) {
        const Vec3 corner = patch.p + patch.u * patch.lo[0] + patch.v * patch.lo[1] - scene.centre;
        const Vec3 u = patch.u * (patch.hi[0] - patch.lo[0]), v = patch.v * (patch.hi[1] - patch.lo[1]);
        const Vec3 dir = patch.sun - patch.n * (2 * dot(patch.n, patch.sun));
        scene.highlights.push_back({flatten::packed(corner), flatten::packed(u), flatten::packed(v),
                                    flatten::packed(patch.n), flatten::packed(dir), patch.alpha2});
    }
}

}  // namespace sampling
