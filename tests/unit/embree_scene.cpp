// SPDX-License-Identifier: BSD-3-Clause
// One Embree scene per tree: geometry 0 = triangles, 1 = shapes, 2.. = instances (tree 0 only).
// The class of a primitive (opaque, transparent) is tested by a filter on triangles and within the shapes' callbacks;
// an instance that forces a class overrules it.
#include "unit/embree_scene.h"

#include <cmath>
#include <cstring>
#include <vector>

#include "bvh/bounds.h"
#include "bvh/embree_device.h"

namespace kernels {
#include "kernels/geom/shapes.h"
}  // namespace kernels

namespace bvh {
namespace {
using namespace kernels;

#if RTC_VERSION_MAJOR >= 4
using RayContext = RTCRayQueryContext;
void init_context(RayContext* c) { rtcInitRayQueryContext(c); }
#else
using RayContext = RTCIntersectContext;
void init_context(RayContext* c) { rtcInitIntersectContext(c); }
#endif

struct Query {  // first member: Embree hands its address to the callbacks
    RayContext context;
    uint32_t mask;
};

constexpr unsigned triangle_geometry = 0, shape_geometry = 1, first_instance = 2;

}  // namespace

struct EmbreeScene::State {
    struct Tree {
        const State* state;
        RTCScene scene = nullptr;
        std::vector<uint32_t> tri_prim, shape_of;  // ids of triangles; shape numbers of geometry 1
    };
    EmbreeDevice device;
    std::vector<Tree> trees;
    const Instance* instances = nullptr;  // geometries 2, 3, ...
    const Shape* shapes = nullptr;
    const uint32_t* shape_prim = nullptr;
    const float* polygon_uv = nullptr;

    ~State() {
        for (Tree& t : trees)
            if (t.scene) rtcReleaseScene(t.scene);
    }
    bool wanted(uint32_t mask, uint32_t id, uint32_t inst_id) const {
        if (inst_id != RTC_INVALID_GEOMETRY_ID) {
            const uint32_t forced = instances[inst_id - first_instance].forced;
            if (forced) return (mask & forced) != 0;
        }
        return (mask >> (id >> 31) & 1) != 0;
    }

    static void filter(const RTCFilterFunctionNArguments* a) {
        const Tree& tree = *static_cast<const Tree*>(a->geometryUserPtr);
        const auto* hit = reinterpret_cast<const RTCHit*>(a->hit);
        const auto* query = reinterpret_cast<const Query*>(a->context);
        const auto* ray = reinterpret_cast<const RTCRay*>(a->ray);
        if (!tree.state->wanted(query->mask, tree.tri_prim[hit->primID], hit->instID[0]) || !(ray->tfar > ray->tnear))
            a->valid[0] = 0;
    }

    static bool meet(const Tree& tree, uint32_t prim, const RayContext* context, const RTCRay& ray, float* t) {
        const State& s = *tree.state;
        const uint32_t shape = tree.shape_of[prim];
        if (!s.wanted(reinterpret_cast<const Query*>(context)->mask, s.shape_prim[shape], context->instID[0]))
            return false;
        return shape_hit(s.shapes + shape, s.polygon_uv, F3(ray.org_x, ray.org_y, ray.org_z),
                         F3(ray.dir_x, ray.dir_y, ray.dir_z), ray.tnear, t) &&
               *t < ray.tfar;
    }

    static void shape_bounds(const RTCBoundsFunctionArguments* a) {
        const Tree& tree = *static_cast<const Tree*>(a->geometryUserPtr);
        Input in;
        in.shapes = tree.state->shapes;
        in.polygon_uv = tree.state->polygon_uv;
        const Shape& shape = in.shapes[tree.shape_of[a->primID]];
        Bounds b = bvh::shape_bounds(in, tree.shape_of[a->primID]);
        const float least = 2e-6f + (shape.kind == SHAPE_POLYGON ? 2 * shape.margin : 0);
        const auto margin = [&](float x) { return std::fabs(x) * 2.4e-7f + least; };
        for (int k = 0; k < 3; k++) {
            b.lo[k] -= margin(b.lo[k]);
            b.hi[k] += margin(b.hi[k]);
        }
        *a->bounds_o = {b.lo[0], b.lo[1], b.lo[2], 0, b.hi[0], b.hi[1], b.hi[2], 0};
    }

    static void shape_intersect(const RTCIntersectFunctionNArguments* a) {
        if (!a->valid[0]) return;
        auto* rh = reinterpret_cast<RTCRayHit*>(a->rayhit);
        float t;
        if (!meet(*static_cast<const Tree*>(a->geometryUserPtr), a->primID, a->context, rh->ray, &t)) return;
        rh->ray.tfar = t;
        rh->hit.u = rh->hit.v = 0;
        rh->hit.primID = a->primID;
        rh->hit.geomID = shape_geometry;
        rh->hit.instID[0] = a->context->instID[0];
    }

    static void shape_occluded(const RTCOccludedFunctionNArguments* a) {
        if (!a->valid[0]) return;
        auto* ray = reinterpret_cast<RTCRay*>(a->ray);
        float t;
        if (meet(*static_cast<const Tree*>(a->geometryUserPtr), a->primID, a->context, *ray, &t)) ray->tfar = -INFINITY;
    }

    void attach(Tree& tree, RTCGeometry g, unsigned id) {
        rtcCommitGeometry(g);
        rtcAttachGeometryByID(tree.scene, g, id);
        rtcReleaseGeometry(g);
    }

    void fill(Tree& tree, const Input& in, bool classes) {
        tree.tri_prim.assign(in.tri_prim, in.tri_prim + in.triangle_count);
        if (in.triangle_count) {
            RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
            void* v = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 12, in.vertex_count);
            void* i = rtcSetNewGeometryBuffer(g, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 12, in.triangle_count);
            device.check();
            std::memcpy(v, in.vertices, 12 * in.vertex_count);
            std::memcpy(i, in.triangles, 12 * in.triangle_count);
            rtcSetGeometryUserData(g, &tree);
            if (classes) {
                rtcSetGeometryIntersectFilterFunction(g, filter);
                rtcSetGeometryOccludedFilterFunction(g, filter);
            }
            attach(tree, g, triangle_geometry);
        }
        for (size_t k = 0; k < in.shape_count; k++) tree.shape_of.push_back(uint32_t(in.first_shape + k));
        for (size_t k = 0; k < in.instance_count; k++) add_instance(tree, in.instances[k], unsigned(k));
        if (!tree.shape_of.empty()) {
            RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
            rtcSetGeometryUserPrimitiveCount(g, unsigned(tree.shape_of.size()));
            rtcSetGeometryUserData(g, &tree);
            rtcSetGeometryBoundsFunction(g, shape_bounds, nullptr);
            rtcSetGeometryIntersectFunction(g, shape_intersect);
            rtcSetGeometryOccludedFunction(g, shape_occluded);
            attach(tree, g, shape_geometry);
        }
    }

    void add_instance(Tree& tree, const Instance& instance, unsigned number) {
        double m[12];
        invert_affine(instance.to_tree, m);
        float rows[12];
        for (int i = 0; i < 12; i++) rows[i] = float(m[i]);
        RTCGeometry g = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
        rtcSetGeometryInstancedScene(g, trees.at(instance.tree).scene);
        rtcSetGeometryTimeStepCount(g, 1);
        rtcSetGeometryTransform(g, 0, RTC_FORMAT_FLOAT3X4_ROW_MAJOR, rows);
        attach(tree, g, first_instance + number);
    }
};

EmbreeScene::EmbreeScene(const Input* trees, size_t tree_count, bool robust, bool classes) : state_(new State) {
    State& s = *state_;
    s.trees.resize(tree_count);
    for (size_t k = tree_count; k-- > 0;) {  // tree 0 last: it refers to the others
        const Input& in = trees[k];
        s.shapes = in.shapes;
        s.instances = in.instances;
        s.shape_prim = in.shape_prim;
        s.polygon_uv = in.polygon_uv;
        s.trees[k].state = &s;
        s.trees[k].scene = rtcNewScene(s.device);
        if (robust) rtcSetSceneFlags(s.trees[k].scene, RTC_SCENE_FLAG_ROBUST);
        s.fill(s.trees[k], in, classes);
        rtcCommitScene(s.trees[k].scene);
        s.device.check();
    }
}

EmbreeScene::~EmbreeScene() = default;

// Embree ends the program over a ray beyond its limits (1.8e18) or of NaN; such a ray meets nothing.
static bool beyond_embree(const float org[3], float tmin, const float dir[3]) {
    const auto takes = [](float x) { return std::fabs(x) < 1e18f; };
    for (int k = 0; k < 3; k++)
        if (!takes(org[k]) || !takes(dir[k])) return true;
    return !takes(tmin);
}

EmbreeScene::Hit EmbreeScene::closest(const float org[3], float tmin, const float dir[3], float tmax,
                                      uint32_t mask) const {
    if (beyond_embree(org, tmin, dir)) return {tmax, NO_HIT, 0, 0, NO_HIT};
    Query query;
    init_context(&query.context);
    query.mask = mask;
    RTCRayHit rh;
    rh.ray = {org[0], org[1], org[2], tmin, dir[0], dir[1], dir[2], 0, tmax, 0xffffffffu, 0, 0};
    rh.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rh.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
#if RTC_VERSION_MAJOR >= 4
    RTCIntersectArguments args;
    rtcInitIntersectArguments(&args);
    args.context = &query.context;
    rtcIntersect1(state_->trees[0].scene, &rh, &args);
#else
    rtcIntersect1(state_->trees[0].scene, &query.context, &rh);
#endif
    if (rh.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {tmax, NO_HIT, 0, 0, NO_HIT};
    const State::Tree* tree = &state_->trees[0];
    uint32_t inst = NO_HIT;
    if (rh.hit.instID[0] != RTC_INVALID_GEOMETRY_ID) {
        inst = rh.hit.instID[0] - first_instance;
        tree = &state_->trees[state_->instances[inst].tree];
    }
    const uint32_t id = rh.hit.geomID == triangle_geometry ? tree->tri_prim[rh.hit.primID]
                                                           : state_->shape_prim[tree->shape_of[rh.hit.primID]];
    return {rh.ray.tfar, id & ID_PRIM, rh.hit.u, rh.hit.v, inst};
}

bool EmbreeScene::any(const float org[3], float tmin, const float dir[3], float tmax, uint32_t mask) const {
    if (beyond_embree(org, tmin, dir)) return false;
    Query query;
    init_context(&query.context);
    query.mask = mask;
    RTCRay ray = {org[0], org[1], org[2], tmin, dir[0], dir[1], dir[2], 0, tmax, 0xffffffffu, 0, 0};
#if RTC_VERSION_MAJOR >= 4
    RTCOccludedArguments args;
    rtcInitOccludedArguments(&args);
    args.context = &query.context;
    rtcOccluded1(state_->trees[0].scene, &ray, &args);
#else
    rtcOccluded1(state_->trees[0].scene, &query.context, &ray);
#endif
    return ray.tfar < 0;
}

}  // namespace bvh
