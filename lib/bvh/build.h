// SPDX-License-Identifier: BSD-3-Clause
// Bounding volume hierarchies for kernels/bvh/bvh8.h and kernels/bvh/bvh_compact.h, by Embree's builder (rtcBuildBVH)
// on all cores.  The arrays go to the device as they are.  Tree 0 is the scene; trees 1, 2, ... are what its
// instances stand for.  One more tree has only what of tree 0 lets shadow rays pass, so
// that they look for panes there alone.  Where trees begin: ROOT_OF_TREE, ROOT_OF_PANES (kernels/bvh/intersect.h).  An
// empty scene gives empty nodes and no leaves. Memory per triangle of large meshes: 55 bytes (BVH8) or 57 (compact),
// with BVH8's 75 at most while building, twice as much for what lets shadow rays pass; scattered
// single polygons take more, up to 200. 10 million triangles: 6.5 s of one core. Limits: 2^29 primitives, 2^30 leaf
// blocks; nodes and leaves are addressed with 64-bit offsets, so more than 4 GB is fine.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <new>
#include <vector>
#include "kernels/dialect/host.h"

namespace bvh {

// Allocator for 64-byte lines, so that a node starts one.
template <class T>
struct AlignedAllocator {
    using value_type = T;
    AlignedAllocator() = default;
    template <class U>
    AlignedAllocator(const AlignedAllocator<U>&) {}
    T* allocate(size_t n) { return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(64))); }
    void deallocate(T* p, size_t) { ::operator delete(p, std::align_val_t(64)); }
    bool operator==(const AlignedAllocator&) const { return true; }
    bool operator!=(const AlignedAllocator&) const { return false; }
};
using AlignedFloats = std::vector<float, AlignedAllocator<float>>;

// Ids (tri_prim, shape_prim): primitive number < 2^29, plus ID_TRANSPARENT (kernels/bvh/intersect.h) for its class.
// Triangles of one polygon share the id.
struct Input {
    const float* vertices = nullptr;  // 3 floats each
    size_t vertex_count = 0;
    const uint32_t* triangles = nullptr;  // 3 vertex numbers each
    const uint32_t* tri_prim = nullptr;   // 1 each
    size_t triangle_count = 0;
    // Shapes first_shape .. first_shape + shape_count - 1 of one table for all trees.
    const kernels::Shape* shapes = nullptr;
    const uint32_t* shape_prim = nullptr;  // 1 each, parallel to shapes
    size_t first_shape = 0, shape_count = 0;
    const float* polygon_uv = nullptr;
    const kernels::Instance* instances = nullptr;  // of tree 0 alone
    size_t instance_count = 0;

    size_t count() const { return triangle_count + shape_count + instance_count; }  // primitives, in this order
    size_t first_instance() const { return triangle_count + shape_count; }
};

struct Tree {
    AlignedFloats nodes, leaves;  // leaves has one unused block if there is no primitive: never an empty buffer
    int depth = 0;                // longest way down, through an instance
};

// Called from time to time with the share of the work done, 0 to 1; from any thread, but from one at a time.
using Tell = std::function<void(double)>;

Tree build8(const Input* trees, size_t tree_count = 1, const Tell& tell = {});
Tree build_compact(const Input* trees, size_t tree_count = 1, const Tell& tell = {});
inline Tree build8(const Input& scene) { return build8(&scene, 1); }
inline Tree build_compact(const Input& scene) { return build_compact(&scene, 1); }

// World from local of an instance's matrix (Instance.to_tree): the inverse, in double, the translation as fourth
// column.
void invert_affine(const float local_from_world[12], double world_from_local[12]);

}  // namespace bvh
