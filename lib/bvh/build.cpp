// SPDX-License-Identifier: BSD-3-Clause
// rtcBuildBVH makes a tree of our small temporary nodes in its own memory; a second pass writes it into the flat arrays
// of kernels/bvh/bvh8.h or kernels/bvh/bvh_compact.h, children of a node side by side. Settings
// (docs/decisions/0008-own-traversal.md): quality MEDIUM (spatial splits were slower); for CPUs blocks of 4, leaves up
// to 16 and a cheap intersection (0.3), because four triangles are tested at once.
#include "bvh/build.h"

#include <algorithm>
#include <memory>

#include "bvh/bounds.h"
#include "bvh/compact_node.h"
#include "bvh/embree_device.h"
#include "bvh/temp_tree.h"

namespace kernels {
#include "kernels/geom/shapes.h"
#include "kernels/bvh/woop.h"
namespace wide {
#include "kernels/bvh/bvh8.h"
}
namespace compact {
#include "kernels/bvh/bvh_compact.h"
}
}  // namespace kernels

namespace bvh {
namespace {
using namespace kernels;

// Differences between the two kinds of tree.
struct Layout {
    bool compact;
    size_t node_floats, leaf_floats;
    unsigned per_block;             // primitives in a leaf block
    int stack;                      // entries of the kernel's stack
    int depth_alone, depth_nested;  // limits of a single tree, and of trees with instances: so that the stack holds
    unsigned sah_block, max_leaf;
    float intersection_cost;
};
constexpr Layout layout8 = {false, BVH8_NODE_FLOATS, BVH8_LEAF_FLOATS, 4, BVH8_STACK, 32, 20, 4, 16, 0.3f};
constexpr Layout layout_compact = {true, COMPACT_NODE_FLOATS, COMPACT_BLOCK_FLOATS, 1, COMPACT_STACK, 48, 20, 1, 4,
                                   0.5f};

class TreeBuilder {
public:
    TreeBuilder(const Layout& layout, const Input* trees, size_t tree_count, const Tell& tell)
        : layout_(layout),
          tell_(tell),
          trees_(trees),
          tree_count_(tree_count),
          tree_bounds_(tree_count + 1, empty_bounds()),
          tree_passes_(tree_count),
          tree_need_(tree_count + 1),
          tree_depth_(tree_count + 1) {
        for (size_t k = 0; k < tree_count; k++) to_do_ += double(trees[k].count());
    }

    Tree build() {
        struct Release {
            void operator()(RTCBVH bvh) const { rtcReleaseBVH(bvh); }
        };
        std::vector<std::unique_ptr<std::remove_pointer_t<RTCBVH>, Release>> memory;  // of the temporary nodes
        const size_t panes = tree_count_, all = tree_count_ + 1;
        std::vector<TempNode*> roots(all, nullptr);
        size_t nodes = all, blocks = 0;
        for (size_t n = all; n-- > 0;) {
            const size_t k = n > 0 ? n - 1 : panes;  // tree 0 needs the boxes of the others, the panes, too
            memory.emplace_back(rtcNewBVH(device_));
            roots[k] = build_tree(k, memory.back().get());
            Need need = roots[k] ? measure(input(k), roots[k]) : Need{};
            tree_need_[k] = need.stack;
            tree_depth_[k] = need.depth;
            nodes += need.nodes;
            blocks += need.blocks;
            if (need.stack + 2 > layout_.stack)
                throw base::Error(base::Kind::system, "", "the scene's tree is too deep");
        }
        if (blocks > REF_INDEX || nodes > REF_LEAF) base::fail("", "too many primitives");
        out_.nodes.assign(nodes * layout_.node_floats, 0.0f);
        out_.leaves.assign(std::max<size_t>(blocks, 1) * layout_.leaf_floats, 0.0f);
        next_node_ = all;
        for (size_t k = 0; k < all; k++) {
            const size_t at = k == 0 ? ROOT_OF_SCENE : k == panes ? ROOT_OF_PANES : ROOT_OF_TREE(k);
            if (roots[k] && roots[k]->children != 0) {
                write_inner(input(k), static_cast<TempInner*>(roots[k]), at);
                continue;
            }
            Slots slots;  // a single leaf gets a node above it, and nothing, too
            if (roots[k]) slots.box[0] = &tree_bounds_[k];
            if (roots[k]) slots.ref[0] = write_leaf(input(k), static_cast<TempLeaf*>(roots[k]));
            write_children(at, slots);
        }
        out_.depth = tree_depth_[0];
        return std::move(out_);
    }

private:
    struct Need {
        size_t nodes = 0, blocks = 0;
        int stack = 0, depth = 0;
    };
    struct Slots {  // of a node: boxes (null: none) and references
        const Bounds* box[max_wide] = {};
        uint32_t ref[max_wide] = {};
    };

    // The tree after the last is that of the panes: what of the scene lets shadow rays pass.
    const Input& input(size_t tree) const { return trees_[tree < tree_count_ ? tree : 0]; }

    bool lets_pass(const Input& in, size_t k) const {
        if (k < in.triangle_count) return (in.tri_prim[k] & ID_TRANSPARENT) != 0;
        if (k < in.first_instance())
            return (in.shape_prim[in.first_shape + k - in.triangle_count] & ID_TRANSPARENT) != 0;
        const Instance& instance = in.instances[k - in.first_instance()];
        return instance.forced != 0 ? (instance.forced & RAY_TRANSPARENT) != 0 : tree_passes_[instance.tree];
    }

    TempNode* build_tree(size_t tree, RTCBVH bvh) {
        const Input& in = input(tree);
        const size_t count = in.count();
        if (count >= ID_PRIM) base::fail("", "too many primitives");
        std::vector<RTCBuildPrimitive> prims;
        if (tree < tree_count_) prims.reserve(count);
        for (size_t k = 0; k < count; k++) {
            const bool passes = lets_pass(in, k);
            if (tree == tree_count_ && !passes) continue;
            if (tree < tree_count_ && passes) tree_passes_[tree] = true;
            const Bounds box = primitive_bounds(in, k, tree_bounds_);
            if (box.lo[0] > box.hi[0]) continue;  // an instance of nothing
            prims.push_back({box.lo[0], box.lo[1], box.lo[2], 0, box.hi[0], box.hi[1], box.hi[2], uint32_t(k)});
            grow(tree_bounds_[tree], box.lo);
            grow(tree_bounds_[tree], box.hi);
        }
        if (prims.empty()) return nullptr;
        const TempSettings settings = {max_wide,
                                       layout_.sah_block,
                                       layout_.max_leaf,
                                       layout_.intersection_cost,
                                       tree_count_ > 1 ? layout_.depth_nested : layout_.depth_alone,
                                       share_told(count)};
        TempNode* root = build_temp_tree(bvh, prims, settings);
        if (tree < tree_count_) done_ += double(count);
        device_.check();
        if (!root) throw base::Error(base::Kind::system, "Embree", "no tree was built");
        return root;
    }

    // Embree's progress on one tree, as a share of all; the tree of panes is part of tree 0.
    Tell share_told(size_t count) const {
        if (!tell_ || done_ >= to_do_) return {};
        return [this, count](double share) { tell_((done_ + share * double(count)) / to_do_); };
    }

    // Memory of a subtree: nodes and blocks of the arrays, and places of the kernel's stack.
    Need measure(const Input& in, const TempNode* node) const {
        Need need;
        if (node->children == 0) {
            const auto* leaf = static_cast<const TempLeaf*>(node);
            unsigned triangles = 0, instances = 0;
            for (unsigned i = 0; i < leaf->prims; i++) {
                if (leaf->prim[i] < in.triangle_count) triangles++;
                if (leaf->prim[i] < in.first_instance()) continue;
                if (&in != trees_) base::fail("", "an instance within an instance was not flattened");
                const Instance& instance = in.instances[leaf->prim[i] - in.first_instance()];
                instances++;
                need.stack = std::max(need.stack, tree_need_[instance.tree]);
                need.depth = std::max(need.depth, tree_depth_[instance.tree]);
            }
            const unsigned n = layout_.per_block;
            need.blocks = (triangles + n - 1) / n + (leaf->prims - triangles + n - 1) / n;
            need.stack += int(instances) + 1;
            return need;
        }
        const auto* inner = static_cast<const TempInner*>(node);
        need.nodes = 1;
        for (unsigned i = 0; i < inner->children; i++) {
            const Need c = measure(in, inner->child[i]);
            need.nodes += c.nodes;
            need.blocks += c.blocks;
            need.stack = std::max(need.stack, c.stack);
            need.depth = std::max(need.depth, c.depth);
        }
        need.stack += layout_.compact ? 1 : int(inner->children) - 1;  // a node waits with all its slots
        need.depth++;
        return need;
    }

    void write_inner(const Input& in, const TempInner* node, size_t at) {
        unsigned slot[max_wide] = {0, 1, 2, 3, 4, 5, 6, 7};
        if (layout_.compact) choose_slots(node->bounds, node->children, slot);
        TempNode* child[max_wide] = {};
        Slots slots;
        for (unsigned i = 0; i < node->children; i++) child[slot[i]] = node->child[i];
        for (unsigned i = 0; i < node->children; i++) slots.box[slot[i]] = &node->bounds[i];
        for (unsigned k = 0; k < max_wide; k++) {
            if (!child[k]) continue;
            slots.ref[k] = child[k]->children != 0 ? uint32_t(next_node_++)
                                                   : write_leaf(in, static_cast<const TempLeaf*>(child[k]));
        }
        write_children(at, slots);
        for (unsigned k = 0; k < max_wide; k++)
            if (child[k] && child[k]->children != 0)
                write_inner(in, static_cast<const TempInner*>(child[k]), slots.ref[k]);
    }

    // One of `wide` boxes, side by side: min x of all, max x, min y ...
    static void write_box(float* at, unsigned wide, const Bounds& box) {
        for (unsigned a = 0; a < 3; a++) {
            at[2 * a * wide] = box.lo[a];
            at[(2 * a + 1) * wide] = box.hi[a];
        }
    }

    void write_children(size_t at, const Slots& slots) {
        float* n = &out_.nodes[at * layout_.node_floats];
        if (layout_.compact) return write_compact_node(n, slots.box, slots.ref);
        const Bounds none = empty_bounds();
        for (unsigned i = 0; i < max_wide; i++) {
            write_box(n + i, max_wide, slots.box[i] ? *slots.box[i] : none);
            n[BVH8_REFS + i] = as_float_(slots.box[i] ? slots.ref[i] : REF_NONE);
        }
    }

    uint32_t write_leaf(const Input& in, const TempLeaf* leaf) {
        const size_t first = next_block_;
        unsigned triangles = 0;
        while (triangles < leaf->prims && leaf->prim[triangles] < in.triangle_count) triangles++;
        const unsigned n = layout_.per_block;
        for (unsigned i = 0; i < triangles; i += n)
            write_triangles(in, leaf->prim + i, std::min(n, triangles - i),
                            i + n >= triangles && triangles == leaf->prims);
        for (unsigned i = triangles; i < leaf->prims; i += n)
            write_shapes(in, leaf->prim + i, std::min(n, leaf->prims - i), i + n >= leaf->prims);
        return uint32_t(first) | REF_LEAF;
    }

    void write_triangles(const Input& in, const uint32_t* prim, unsigned count, bool last) {
        float* b = &out_.leaves[next_block_++ * layout_.leaf_floats];
        const unsigned n = layout_.per_block;
        for (unsigned i = 0; i < count; i++) {
            for (int k = 0; k < 3; k++) {
                const float* v = in.vertices + 3 * size_t(in.triangles[3 * size_t(prim[i]) + k]);
                for (int a = 0; a < 3; a++) b[n == 4 ? 12 * k + 4 * a + i : 4 * k + a] = v[a];
            }
        }  // lanes left over are triangles of no size
        for (unsigned i = 0; i < n; i++) {
            const uint32_t id =
                (i < count ? in.tri_prim[prim[i]] & (ID_PRIM | ID_TRANSPARENT) : 0) | (last ? ID_LAST : 0);
            b[n == 4 ? 36 + i : 3] = as_float_(id);
        }
    }

    void write_shapes(const Input& in, const uint32_t* prim, unsigned count, bool last) {
        float* b = &out_.leaves[next_block_++ * layout_.leaf_floats];
        const unsigned n = layout_.per_block;
        const Bounds none = empty_bounds();
        for (unsigned i = 0; i < n; i++) {
            uint32_t number = 0, id = ID_SHAPE | (last ? ID_LAST : 0);
            if (i < count && prim[i] >= in.first_instance()) {
                number = uint32_t(prim[i] - in.first_instance()) | REF_INSTANCE;
            } else if (i < count) {
                number = uint32_t(in.first_shape + (prim[i] - in.triangle_count));
                id |= in.shape_prim[number] & (ID_PRIM | ID_TRANSPARENT);
            }
            b[i] = as_float_(number);
            b[n == 4 ? 36 + i : 3] = as_float_(id);
            if (n == 4)
                write_box(b + BVH8_BOXES + i, 4, i < count ? primitive_bounds(in, prim[i], tree_bounds_) : none);
        }
    }

    const Layout& layout_;
    const Tell& tell_;
    double done_ = 0, to_do_ = 0;  // primitives
    const Input* trees_;
    size_t tree_count_;
    EmbreeDevice device_;
    std::vector<Bounds> tree_bounds_;
    std::vector<bool> tree_passes_;  // does it hold anything that lets shadow rays pass?
    std::vector<int> tree_need_, tree_depth_;
    Tree out_;
    size_t next_node_ = 0, next_block_ = 0;
};

}  // namespace

Tree build8(const Input* trees, size_t tree_count, const Tell& tell) {
    return TreeBuilder(layout8, trees, tree_count, tell).build();
}

Tree build_compact(const Input* trees, size_t tree_count, const Tell& tell) {
    return TreeBuilder(layout_compact, trees, tree_count, tell).build();
}

}  // namespace bvh
