// SPDX-License-Identifier: BSD-3-Clause
// Shared by the two rasterizers (raster.cpp, scene.cpp): a region's tree as one field over the view.
// In a tree, union is the greater, intersection the lesser value, complement the negative: with values in units of the
// cell's radius (see shape.h) |value| > 1 stays "the whole cell is in / out" through every operation.
#pragma once
#include <functional>
#include <memory>
#include <vector>
#include "region/shape.h"

namespace region {

// Largest distance of a cell's points from its centre.
struct Reach {
    double angle, pixel;
};

class Prepared {
public:
    // Fields of every shape that the regions use; throws for those the view cannot have.
    Prepared(const Regions& regions, const view::View& view, int nx, int ny);
    double value(int node, const Point& p, const Reach& reach) const;
    double view_field(const Point& p, const Reach& reach) const;  // the angular fisheye ends at 90 degrees

    const Regions& regions;
    Space space;
    std::vector<Field> fields;  // by shape; none for surface and modifier
};

// Calls work(i) for i = 0 .. count-1 on all processors; the first exception is thrown again here.
void for_all(size_t count, const std::function<void(size_t)>& work);

// A square of pixels of the picture (cut at its border), its centre and its reach; reach.angle is infinite where some
// of it shows nothing, `blank` where none of it shows anything.
struct Cell {
    int x, y, size;
};
struct CellGeometry {
    Point centre;
    Reach reach;
    bool blank;
};
CellGeometry cell_geometry(const Space& space, const Cell& cell);

// Walks the picture from coarse to fine.  sure(cell, in) for cells wholly in or out, open(x, y, geometry) for single
// pixels that are neither.  value(geometry, cell) in units of the cell's radius.
class Pyramid {
public:
    explicit Pyramid(const Space& space);
    template <class Value, class Sure, class Open>
    void walk(const Value& value, const Sure& sure, const Open& open) const;

private:
    const CellGeometry* stored(const Cell& c) const;
    template <class Value, class Sure, class Open>
    void walk(const Cell& c, const Value& value, const Sure& sure, const Open& open) const;
    static constexpr int coarse = 64, fine = 8;
    const Space& space_;
    struct Level {
        int size, across;
        std::vector<CellGeometry> cells;
    };
    std::vector<Level> levels_;  // sizes coarse .. fine; smaller cells are evaluated on demand
};

void fill(std::vector<float>& plane, const Space& s, const Cell& c, float v);
// One region by its shapes alone.
void rasterize_plain(const Prepared& prepared, const Pyramid& pyramid, size_t region, bool centre,
                     std::vector<float>& plane);
// All regions as a scene shows them (scene.cpp).
void rasterize_scene(const Prepared& prepared, const SceneView& eye, bool centre, image::MaskSet& set);

template <class Value, class Sure, class Open>
void Pyramid::walk(const Value& value, const Sure& sure, const Open& open) const {
    for (int y = 0; y < space_.ny; y += coarse)
        for (int x = 0; x < space_.nx; x += coarse) walk(Cell{x, y, coarse}, value, sure, open);
}
template <class Value, class Sure, class Open>
void Pyramid::walk(const Cell& c, const Value& value, const Sure& sure, const Open& open) const {
    if (c.x >= space_.nx || c.y >= space_.ny) return;
    const CellGeometry* g = stored(c);
    CellGeometry own;
    if (!g) own = cell_geometry(space_, c), g = &own;
    double v = g->blank ? -2 : value(*g, c);
    if (v > 1 || v < -1) return sure(c, v > 0);
    if (c.size == 1) return open(c.x, c.y, *g);
    int h = c.size / 2;
    for (int k = 0; k < 4; ++k) walk(Cell{c.x + (k & 1) * h, c.y + (k >> 1) * h, h}, value, sure, open);
}

}  // namespace region
