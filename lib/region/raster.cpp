// SPDX-License-Identifier: BSD-3-Clause
// Coverage without a scene.  Cells of the picture are halved until their field says all in or all out; pixels on a
// border remain.  They are halved further while the field bends; then the coverage of a cell is that of the linear
// interpolation over its four triangles (corner, corner, centre): exact for straight borders, and within 0.001 of a
// pixel for others.  The result does not depend on threads or random numbers, so the bytes repeat.
#include "region/raster.h"
#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include "base/angle.h"
#include "base/error.h"
#include "base/hypot.h"
#include "base/memory.h"
#include "base/processors.h"
#include "base/threads.h"
#include "region/arcs.h"
#include "region/picture.h"

namespace region {

Prepared::Prepared(const Regions& r, const view::View& view, int nx, int ny) : regions(r), space(view, nx, ny) {
    fields.resize(regions.shapes.size());
    for (size_t i = 0; i < fields.size(); ++i)
        if (regions.shapes[i].kind != Kind::surface && regions.shapes[i].kind != Kind::modifier)
            fields[i] = make_field(regions.shapes[i], space);
}

double Prepared::view_field(const Point& p, const Reach& reach) const {
    if (space.projector.view().type != 'a') return 2;
    return (base::pi / 2 - angle_between(p.dir, space.projector.forward())) / reach.angle;
}

double Prepared::value(int node, const Point& p, const Reach& reach) const {
    const Node& n = regions.nodes[size_t(node)];
    switch (n.op) {
    case 's': {
        const Field& f = fields[size_t(n.a)];
        return f.value(p) / (f.in_picture ? reach.pixel : reach.angle);
    }
    case '+': return std::max(value(n.a, p, reach), value(n.b, p, reach));
    case '&': return std::min(value(n.a, p, reach), value(n.b, p, reach));
    case '-': return std::min(value(n.a, p, reach), -value(n.b, p, reach));
    default: return std::min(-value(n.a, p, reach), view_field(p, reach));
    }
}

void for_all(size_t count, const std::function<void(size_t)>& work) {
    base::in_shares(count, 1, base::processors(), [&](size_t k, size_t) { work(k); });
}

CellGeometry cell_geometry(const Space& s, const Cell& c) {
    double x0 = c.x, y0 = c.y, x1 = std::min(c.x + c.size, s.nx), y1 = std::min(c.y + c.size, s.ny);
    double xm = (x0 + x1) / 2, ym = (y0 + y1) / 2;
    CellGeometry g;
    bool any = s.point(xm, ym, g.centre), all = any;
    double reach = 0;
    const double rim[8][2] = {{x0, y0}, {x1, y0}, {x0, y1}, {x1, y1}, {xm, y0}, {xm, y1}, {x0, ym}, {x1, ym}};
    for (int k = 0; k < (c.size > 8 ? 8 : 4); ++k) {
        Point p;
        bool seen = s.point(rim[k][0], rim[k][1], p);
        any = any || seen;
        all = all && seen;
        if (all) reach = std::max(reach, angle_between(p.dir, g.centre.dir));
    }
    g.blank = !any;
    g.reach.angle = all ? reach * (c.size > 8 ? 1.2 : 1.05) : INFINITY;  // room for the projection's bend
    g.reach.pixel = base::hypot(x1 - x0, y1 - y0) / 2 * (1 + 1e-9);
    if (!all) g.reach.pixel = INFINITY;
    return g;
}

Pyramid::Pyramid(const Space& space) : space_(space) {
    for (int size = coarse; size >= fine; size /= 2) {
        Level level{size, (space.nx + size - 1) / size, {}};
        int down = (space.ny + size - 1) / size;
        level.cells.resize(size_t(level.across) * size_t(down));
        levels_.push_back(std::move(level));
    }
    for (Level& level : levels_)
        for_all(level.cells.size() / size_t(level.across), [&](size_t row) {
            for (int i = 0; i < level.across; ++i)
                level.cells[row * size_t(level.across) + size_t(i)] =
                    cell_geometry(space_, {i * level.size, int(row) * level.size, level.size});
        });
}

const CellGeometry* Pyramid::stored(const Cell& c) const {
    for (const Level& level : levels_)
        if (level.size == c.size)
            return &level.cells[size_t(c.y / c.size) * size_t(level.across) + size_t(c.x / c.size)];
    return nullptr;
}

namespace {

// The share of a triangle where a field, linear between its corners, is positive.
double positive_share(double a, double b, double c) {
    int n = (a > 0) + (b > 0) + (c > 0);
    if (n == 0 || n == 3) return n == 3;
    double odd = n == 1 ? (a > 0 ? a : b > 0 ? b : c) : (a <= 0 ? a : b <= 0 ? b : c);
    double sum = 1;  // the corner of the other sign cuts off odd^2 / ((odd - p)(odd - q))
    bool skipped = false;
    for (double v : {a, b, c}) {
        if (!skipped && v == odd) {
            skipped = true;
            continue;
        }
        sum *= odd / (odd - v);
    }
    return n == 1 ? sum : 1 - sum;
}

class Pixel {
public:
    Pixel(const Prepared& scene, int node, const CellGeometry& g) : scene_(scene), node_(node), reach_(g.reach) {
        if (!std::isfinite(reach_.pixel)) {  // at the rim of the image circle: any scale will do
            reach_.pixel = std::sqrt(.5);
            Point p, q;
            reach_.angle = 0.01;
            if (g.centre.dir == Vec3{}) return;
            for (double dx : {-.25, .25})
                if (scene_.space.point(g.centre.x + dx, g.centre.y, p) && scene_.space.point(g.centre.x, g.centre.y, q))
                    reach_.angle = 4 * angle_between(p.dir, q.dir);
        }
    }
    double coverage(int x, int y) {
        double f[4] = {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y + 1)};
        return share(x, y, 1, f, 0);
    }

private:
    double at(double x, double y) {
        Point p;
        return scene_.space.point(x, y, p) ? scene_.value(node_, p, reach_) : -0.5;
    }
    double share(double x, double y, double size, const double f[4], int depth) {
        double m = at(x + size / 2, y + size / 2);
        if (std::fabs(m) > size) return m > 0;
        double low = std::min({f[0], f[1], f[2], f[3]}), high = std::max({f[0], f[1], f[2], f[3]});
        double bend = std::fabs(m - (f[0] + f[1] + f[2] + f[3]) / 4) + std::fabs(f[0] + f[3] - f[1] - f[2]) / 8;
        if (depth == 4 || bend * size <= 5e-4 * (high - low))
            return (positive_share(f[0], f[1], m) + positive_share(f[1], f[3], m) + positive_share(f[3], f[2], m) +
                    positive_share(f[2], f[0], m)) /
                   4;
        double h = size / 2;
        double bottom = at(x + h, y), top = at(x + h, y + size), left = at(x, y + h), right = at(x + size, y + h);
        const double quarter[4][4] = {
            {f[0], bottom, left, m}, {bottom, f[1], m, right}, {left, m, f[2], top}, {m, right, top, f[3]}};
        double sum = 0;
        for (int k = 0; k < 4; ++k) sum += share(x + (k & 1) * h, y + (k >> 1) * h, h, quarter[k], depth + 1);
        return sum / 4;
    }
    const Prepared& scene_;
    int node_;
    Reach reach_;
};

// A region that is nothing but a mask keeps the mask's grey.
const Shape* plain_mask(const Regions& r, const Region& region) {
    const Node& n = r.nodes[size_t(region.root)];
    if (n.op != 's' || r.shapes[size_t(n.a)].kind != Kind::mask) return nullptr;
    return &r.shapes[size_t(n.a)];
}

}  // namespace

void fill(std::vector<float>& plane, const Space& s, const Cell& c, float v) {
    int x1 = std::min(c.x + c.size, s.nx), y1 = std::min(c.y + c.size, s.ny);
    for (int y = c.y; y < y1; ++y) {
        float* row = &plane[size_t(s.ny - 1 - y) * size_t(s.nx)];
        std::fill(row + c.x, row + x1, v);
    }
}

void rasterize_plain(const Prepared& prepared, const Pyramid& pyramid, size_t i, bool centre,
                     std::vector<float>& plane) {
    const Region& region = prepared.regions.regions[i];
    const int nx = prepared.space.nx, ny = prepared.space.ny;
    if (const Shape* mask = plain_mask(prepared.regions, region)) {
        plane = resample(read_mask_picture(*mask), nx, ny);
        if (centre)
            for (float& v : plane) v = v >= .5f;
        return;
    }
    plane.assign(size_t(nx) * size_t(ny), 0.f);
    pyramid.walk(
        [&](const CellGeometry& g, const Cell&) {
            return g.centre.dir == Vec3{} ? 0 : prepared.value(region.root, g.centre, g.reach);
        },
        [&](const Cell& c, bool in) {
            if (in) fill(plane, prepared.space, c, 1);
        },
        [&](int x, int y, const CellGeometry& g) {
            float& out = plane[size_t(ny - 1 - y) * size_t(nx) + size_t(x)];
            if (centre) out = !(g.centre.dir == Vec3{}) && prepared.value(region.root, g.centre, {1, 1}) >= 0;
            else out = float(std::clamp(Pixel(prepared, region.root, g).coverage(x, y), 0.0, 1.0));
        });
}

image::MaskSet rasterize(const Regions& regions, const view::View& view, int nx, int ny, bool centre,
                         const SceneView* eye) {
    if (nx < 1 || ny < 1 || int64_t(nx) * ny > (int64_t(1) << 28))
        base::fail("", fmt::format("a picture of {} x {} pixels is not possible", nx, ny));
    const double bytes = 4.0 * nx * ny * double(regions.regions.size()), memory = double(base::machine_memory());
    if (memory > 0 && bytes > .8 * memory)
        base::fail(regions.file, fmt::format("{} regions of {} x {} pixels need {:.1f} GB; this machine has {:.1f} GB",
                                             regions.regions.size(), nx, ny, bytes * 1e-9, memory * 1e-9));
    image::MaskSet set;
    set.width = nx;
    set.height = ny;
    set.header.view = view;
    set.masks.resize(regions.regions.size());
    Prepared scene(regions, view, nx, ny);
    for (size_t i = 0; i < regions.regions.size(); ++i) set.masks[i].name = regions.regions[i].name;
    if (eye) {
        rasterize_scene(scene, *eye, centre, set);
        return set;
    }
    for (const Shape& s : regions.shapes)
        if (s.kind == Kind::surface || s.kind == Kind::modifier)
            base::fail(s.place, "asks for a surface or modifier, but no scene is given");
    Pyramid pyramid(scene.space);
    for_all(set.masks.size(), [&](size_t i) { rasterize_plain(scene, pyramid, i, centre, set.masks[i].coverage); });
    return set;
}

}  // namespace region
