// SPDX-License-Identifier: BSD-3-Clause
// See bsdf_tree.h.
#include "scene/bsdf_tree.h"

#include <algorithm>
#include <fmt/core.h>
#include "base/error.h"
#include "scene/bsdf_text.h"

namespace scene {
namespace {

constexpr int max_depth = 12;  // a tensor of 2^12 = 4096 cells a side is finer than any instrument

class TreeReader {
public:
    TreeReader(const char* text, int dims, const std::string& place, BsdfTree& tree)
        : in_(text, place), place_(place), tree_(tree), dims_(dims) {}
    void read() {
        tree_.dims = dims_;
        tree_.value.push_back(0);
        tree_.child.push_back(BsdfTree::LEAF);
        node(0, 0);
        if (in_.peek()) base::fail(place_, "more scattering data than the tensor tree holds");
    }

private:
    uint32_t split(uint32_t parent) {
        const size_t first = tree_.value.size(), count = size_t(1) << dims_;
        tree_.value.resize(first + count, 0.0f);
        tree_.child.resize(first + count, BsdfTree::LEAF);
        tree_.child[parent] = uint32_t(first);
        return uint32_t(first);
    }
    void node(uint32_t at, int depth) {
        if (in_.peek() != '{') base::fail(place_, "a tensor tree lacks an opening brace");
        in_.take();
        if (in_.peek() == '{') {
            if (depth >= max_depth)
                base::fail(place_, fmt::format("a tensor tree is deeper than {} levels", max_depth));
            const uint32_t first = split(at);
            for (uint32_t c = 0; c < 1u << dims_; c++) node(first + c, depth + 1);
        } else {
            std::vector<float> grid;
            while (in_.peek() != '}') grid.push_back(in_.value());
            int levels = 0;
            while (levels < max_depth && size_t(1) << (levels * dims_) < grid.size()) levels++;
            if (size_t(1) << (levels * dims_) != grid.size())
                base::fail(place_,
                           fmt::format("a leaf of a tensor tree has {} values, which fill no grid of {} dimensions",
                                       grid.size(), dims_));
            if (depth + levels > max_depth)
                base::fail(place_, fmt::format("a tensor tree is deeper than {} levels", max_depth));
            tree_.depth = std::max(tree_.depth, depth + levels);
            expand(at, grid, levels, levels, 0);
        }
        if (in_.peek() != '}') base::fail(place_, "a tensor tree lacks a closing brace");
        in_.take();
    }
    // The grid (dimension 0 slowest) below a node; low = index of the node's lower corner.
    void expand(uint32_t at, const std::vector<float>& grid, int levels, int left, size_t low) {
        if (left == 0) {
            tree_.value[at] = grid[low];
            return;
        }
        const uint32_t first = split(at);
        for (uint32_t c = 0; c < 1u << dims_; c++) {
            size_t corner = low;
            for (int k = 0; k < dims_; k++)
                if (c >> k & 1) corner += size_t(1) << ((left - 1) + levels * (dims_ - 1 - k));
            expand(first + c, grid, levels, left - 1, corner);
        }
    }
    BsdfNumbers in_;
    const std::string& place_;
    BsdfTree& tree_;
    int dims_;
};

}  // namespace

BsdfTree read_bsdf_tree(const char* text, int dims, const std::string& place) {
    BsdfTree tree;
    TreeReader(text, dims, place, tree).read();
    return tree;
}

}  // namespace scene
