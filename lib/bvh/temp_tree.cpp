// SPDX-License-Identifier: BSD-3-Clause
// See temp_tree.h.
#include "bvh/temp_tree.h"

#include <algorithm>
#include <exception>
#include <mutex>

namespace bvh {

namespace {

struct Watch {
    const Tell& tell;
    std::mutex one_at_a_time;
    std::exception_ptr given_up;
};

bool watched(void* user, double share) {
    auto* watch = static_cast<Watch*>(user);
    const std::unique_lock<std::mutex> hold(watch->one_at_a_time, std::try_to_lock);
    if (!hold.owns_lock()) return true;  // go on
    try {
        if (!watch->given_up) watch->tell(std::min(share, 1.0));
    } catch (...) {  // no exception may pass through Embree
        watch->given_up = std::current_exception();
    }
    return !watch->given_up;
}

}  // namespace

TempNode* build_temp_tree(RTCBVH bvh, std::vector<RTCBuildPrimitive>& prims, const TempSettings& settings) {
    RTCBuildArguments args = rtcDefaultBuildArguments();
    args.buildQuality = RTC_BUILD_QUALITY_MEDIUM;
    args.maxBranchingFactor = settings.wide;
    args.maxDepth = settings.max_depth;
    args.sahBlockSize = settings.sah_block;
    args.minLeafSize = 1;
    args.maxLeafSize = settings.max_leaf;
    args.traversalCost = 1.0f;
    args.intersectionCost = settings.intersection_cost;
    args.bvh = bvh;
    args.primitives = prims.data();
    args.primitiveCount = args.primitiveArrayCapacity = prims.size();
    args.createNode = [](RTCThreadLocalAllocator memory, unsigned n, void*) -> void* {
        auto* node = static_cast<TempInner*>(rtcThreadLocalAlloc(memory, sizeof(TempInner), 16));
        node->children = n;
        return node;
    };
    args.setNodeChildren = [](void* node, void** child, unsigned n, void*) {
        for (unsigned i = 0; i < n; i++) static_cast<TempInner*>(node)->child[i] = static_cast<TempNode*>(child[i]);
    };
    args.setNodeBounds = [](void* node, const RTCBounds** b, unsigned n, void*) {
        for (unsigned i = 0; i < n; i++)
            static_cast<TempInner*>(node)->bounds[i] = {{b[i]->lower_x, b[i]->lower_y, b[i]->lower_z},
                                                        {b[i]->upper_x, b[i]->upper_y, b[i]->upper_z}};
    };
    args.createLeaf = [](RTCThreadLocalAllocator memory, const RTCBuildPrimitive* p, size_t n, void*) -> void* {
        auto* leaf = static_cast<TempLeaf*>(rtcThreadLocalAlloc(memory, sizeof(TempLeaf) + 4 * n, 16));
        leaf->children = 0;
        leaf->prims = unsigned(n);
        for (size_t i = 0; i < n; i++) leaf->prim[i] = p[i].primID;
        std::sort(leaf->prim, leaf->prim + n);  // threads may partition in any order; results must not depend on it
        return leaf;
    };
    Watch watch{settings.tell, {}, nullptr};
    args.userPtr = &watch;
    if (settings.tell) args.buildProgress = watched;
    auto* root = static_cast<TempNode*>(rtcBuildBVH(&args));
    if (watch.given_up) std::rethrow_exception(watch.given_up);
    return root;
}

}  // namespace bvh
