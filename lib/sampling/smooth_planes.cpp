// SPDX-License-Identifier: BSD-3-Clause
// See smooth_planes.h.
#include "sampling/smooth_planes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "flatten/pack.h"
#include "kernels/dialect/host.h"

namespace sampling {
using namespace kernels;
using base::Vec3;
using flatten::bits;

namespace {

constexpr int DEEPEST = 16;               // mixtures one inside the other
constexpr size_t MOST_PLACED = 1u << 20;  // planes of instances
constexpr float SMOOTH = 1e-6f;           // roughness squared, as of mat_normal.h
constexpr uint32_t IN_TRIANGLE = ~(1u << 31);

struct Plane {
    Vec3 normal;
    double size = 0;  // of the largest surface
};
using Planes = std::map<std::array<int, 3>, Plane>;

// Adds a normal, with the sign that makes its largest component positive, so that both sides are one.
void add(Planes& planes, Vec3 normal, double size) {
    const double x = std::fabs(normal.x), y = std::fabs(normal.y), z = std::fabs(normal.z);
    const double largest = x >= y && x >= z ? normal.x : y >= z ? normal.y : normal.z;
    if (largest < 0) normal = -normal;
    const auto step = [](double v) { return int(std::lround(v / same_plane_rad)); };
    Plane& plane = planes[{step(normal.x), step(normal.y), step(normal.z)}];
    if (size > plane.size) plane = {normal, size};
}

class Finder {
public:
    explicit Finder(const flatten::FlatScene& scene) : scene_(scene) {}

    // In the tree's own coordinates; mod: of an instance, in place of all modifiers inside (NONE: their own).
    Planes of_tree(const flatten::FlatScene::Tree& tree, uint32_t mod) {
        Planes planes;
        uint32_t last = NONE;
        const auto see = [&](uint32_t prim) {
            if (prim == last) return;
            last = prim;
            const Prim& p = scene_.prims[prim];
            const uint32_t kind = p.kind & PRIM_KIND_MASK;
            const bool flat = kind == PRIM_FLAT || (kind == PRIM_SMOOTH && (p.kind & PRIM_CORNER_NORMALS) == 0);
            const bool ball = kind == PRIM_SPHERE && &tree == &scene_.trees[0] && balls.size() < MOST_BALLS;
            if (curved && !flat && !ball) return;
            const Chain& chain = chain_of(mod == NONE ? p.mod : mod);
            if (!chain.smooth) return;
            curved = curved || !flat || chain.bends;
            if (ball) {
                const Shape& shape = scene_.shapes[p.at];
                balls.push_back({scene_.centre + flatten::vec_of(shape.centre), double(shape.radius)});
            }
            if (!flat) return;
            const double size = double(flatten::from_bits(p.kind >> PRIM_EXTENT_SHIFT << 23));
            add(planes, flatten::vec_of(p.normal), size);
        };
        const flatten::Geometry& geometry = *scene_.geometry;
        for (size_t i = 0; i < tree.triangle_count; i++) see(geometry.tri_prim[tree.first_triangle + i] & IN_TRIANGLE);
        for (size_t i = 0; i < tree.shape_count; i++) see(geometry.shape_prim[tree.first_shape + i] & IN_TRIANGLE);
        return planes;
    }

    bool curved = false;
    std::vector<Ball> balls;

private:
    // A modifier with those before it: whether it reflects without roughness; whether its rays may leave in other
    // directions than a plane's mirror gives: textures, solids.
    struct Chain {
        bool smooth = false, bends = false;
    };
    const Chain& chain_of(uint32_t mod) {
        const auto [known, fresh] = chains_.emplace(mod, Chain());
        if (fresh) read(mod, 0, known->second);
        return known->second;
    }

    void read(uint32_t mod, int depth, Chain& chain) const {
        while (mod != NONE && scene_.modifiers[mod].type < M_FIRST_MATERIAL) {
            const Modifier& m = scene_.modifiers[mod];
            chain.bends = chain.bends || m.type == M_TEXTURE;
            if (m.type == M_MIXTURE && depth < DEEPEST)
                for (const uint32_t branch : {m.branch1, m.branch2}) read(branch, depth + 1, chain);
            mod = m.next;
        }
        if (mod == NONE) return;
        for (uint32_t next = scene_.modifiers[mod].next; next != NONE; next = scene_.modifiers[next].next)
            chain.bends = chain.bends || scene_.modifiers[next].type == M_TEXTURE;
        chain.smooth = chain.smooth || reflects(mod);
        chain.bends = chain.bends || (material_has(scene_.modifiers[mod].type, MT_BENDS) != 0 && reflects(mod));
    }

    bool reflects(uint32_t mod) const {
        const Modifier& m = scene_.modifiers[mod];
        const float* arg = &scene_.f[m.args];
        switch (m.type) {
        case M_GLASS:
        case M_MIRROR:
        case M_DIELECTRIC:
        case M_INTERFACE:
        case M_BRTD: return true;
        case M_PLASTIC:
        case M_METAL:
        case M_TRANS: return arg[4] * arg[4] <= SMOOTH && arg[3] > 0;
        default: return false;
        }
    }

    const flatten::FlatScene& scene_;
    std::map<uint32_t, Chain> chains_;
};

// The normal of a plane of an instance, in the world: the matrix leads from there into the tree.
Vec3 turned(const float* matrix, Vec3 n) {
    Vec3 out;
    for (int j = 0; j < 3; j++)
        out[j] = n.x * double(matrix[j]) + n.y * double(matrix[4 + j]) + n.z * double(matrix[8 + j]);
    return base::unit(out);
}

}  // namespace

SmoothSurfaces smooth_surfaces(const flatten::FlatScene& scene) {
    Finder finder(scene);
    if (scene.trees.empty()) return {};
    Planes planes = finder.of_tree(scene.trees[0], NONE);
    std::map<std::pair<uint32_t, uint32_t>, Planes> of_tree;  // by tree and replacing modifier
    size_t placed = 0;
    for (size_t i = 0; i < scene.instance_object.size() && placed < MOST_PLACED; i++) {
        const Instance& instance = scene.instances[i];
        const uint32_t tree = instance.tree, mod = instance.mod;
        const auto [inside, fresh] = of_tree.emplace(std::make_pair(tree, mod), Planes());
        if (fresh) inside->second = finder.of_tree(scene.trees[tree], mod);
        for (const auto& [key, plane] : inside->second) {
            add(planes, turned(instance.to_tree, plane.normal), plane.size);
            placed++;
        }
    }

    std::vector<Plane> sorted;
    for (const auto& [key, plane] : planes) sorted.push_back(plane);
    std::stable_sort(sorted.begin(), sorted.end(), [](const Plane& a, const Plane& b) { return a.size > b.size; });
    SmoothSurfaces out;
    out.curved = finder.curved;
    out.balls = finder.balls;
    std::vector<Vec3>& kept = out.planes;
    const double same = 1 - same_plane_rad * same_plane_rad / 2;
    for (size_t i = 0; i < sorted.size() && kept.size() < MOST_PLANES; i++)
        if (std::none_of(kept.begin(), kept.end(), [&](Vec3 n) { return std::fabs(dot(n, sorted[i].normal)) > same; }))
            kept.push_back(sorted[i].normal);
    return out;
}

}  // namespace sampling
