// SPDX-License-Identifier: BSD-3-Clause
// Which bright pixels belong together (connect.h), in many pictures that differ in few pixels.  What is bright in all
// of them is joined once, to nodes; a pixel that is bright in some joins the node of its cell or is one of its own.
// Which nodes are one group then differs from picture to picture.
#pragma once
#include <cstdint>
#include <vector>
#include "comfort/connect.h"

namespace comfort {

using Shown = uint32_t;  // bit k: in picture k

// Neighbouring pixels of one row, bright in the same pictures.
struct Stretch {
    uint32_t start, length;
    Shown shown;
    uint32_t node = 0;
};

class SwayedGroups {
public:
    // Stretches in picture order.  Sets their nodes, and cuts them where these differ; their order is lost.
    SwayedGroups(const Geometry& geometry, Connector& connector, std::vector<Stretch>& stretches, int pictures);
    uint32_t nodes() const { return nodes_; }
    uint32_t root(int picture, uint32_t node) const;  // the group's, of nodes that have a pixel in this picture

private:
    struct Cell {
        uint32_t node;
        Shown shown;  // in which pictures it has a pixel
        bool wavers;  // has one that not all show
    };
    struct Pixel {
        uint32_t pixel, cell;
        Shown shown;
        Vec3 direction;  // when it is needed
    };
    std::vector<Pixel> find_cells(std::vector<Stretch>& wavering);
    void join_cells(const std::vector<Pixel>& pixels);
    void join(Pixel* a, size_t as, Pixel* b, size_t bs, Shown open);
    size_t at(int picture, uint32_t node) const { return size_t(picture) * nodes_ + node; }
    Shown apart(uint32_t a, uint32_t b) const;

    const Geometry& geometry_;
    Connector& connector_;
    int pictures_;
    Shown all_;
    uint32_t nodes_ = 0;
    std::vector<Run> common_;       // bright in all; a group is a node
    std::vector<Cell> cells_;       // the connector's
    std::vector<uint32_t> parent_;  // by picture and node; empty: each node is a group
};

}  // namespace comfort
