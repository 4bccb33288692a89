// SPDX-License-Identifier: BSD-3-Clause
// One region of a file without the others, so that a shape that this view cannot have hides no other region.
#include "region/region.h"

namespace region {
namespace {

// Copies the tree below a node of `from`; returns its root in `to`.
int copy(const Regions& from, int node, Regions& to) {
    Node n = from.nodes[size_t(node)];
    if (n.op == 's') {
        Shape shape = from.shapes[size_t(n.a)];
        if (shape.within >= 0) {
            to.shapes.push_back(from.shapes[size_t(shape.within)]);
            shape.within = int(to.shapes.size()) - 1;
        }
        to.shapes.push_back(shape);
        n.a = int(to.shapes.size()) - 1;
    } else {
        n.a = copy(from, n.a, to);
        if (n.b >= 0) n.b = copy(from, n.b, to);
    }
    to.nodes.push_back(n);
    return int(to.nodes.size()) - 1;
}

}  // namespace

Regions only(const Regions& regions, size_t k) {
    Regions one;
    one.file = regions.file;
    Region region = regions.regions[k];
    region.root = copy(regions, region.root, one);
    one.regions.push_back(region);
    return one;
}

}  // namespace region
