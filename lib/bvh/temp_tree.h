// SPDX-License-Identifier: BSD-3-Clause
// Embree's builder makes a tree of small temporary nodes in its own memory, which build.cpp writes into flat arrays.
#pragma once
#include <cstdint>
#include <vector>

#include "bvh/bounds.h"
#include "bvh/embree_device.h"

namespace bvh {

constexpr unsigned max_wide = 8;

struct TempNode {  // an inner node, or a leaf if children == 0
    unsigned children, prims;
};
struct TempInner : TempNode {
    TempNode* child[max_wide];
    Bounds bounds[max_wide];
};
struct TempLeaf : TempNode {
    uint32_t prim[1];  // prims of them
};

struct TempSettings {
    unsigned wide;  // children of a node, at most
    unsigned sah_block, max_leaf;
    float intersection_cost;
    int max_depth;
    Tell tell;
};

// Null if Embree could not; the nodes live as long as bvh.
TempNode* build_temp_tree(RTCBVH bvh, std::vector<RTCBuildPrimitive>& prims, const TempSettings& settings);

}  // namespace bvh
