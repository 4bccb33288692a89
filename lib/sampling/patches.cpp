// SPDX-License-Identifier: BSD-3-Clause
// Rays along the sunlight from a grid of points on each window: those that hit one plane are a piece of the window,
// whose image on the plane is a parallelogram.  A piece that is mostly dark is cut in two.
#include "sampling/patches.h"

#include <algorithm>
#include <cmath>

#include "sampling/suns.h"

namespace sampling {
namespace {
using base::Vec3;

constexpr int SIDE = 64;                  // of the grid
constexpr int LEAST_CELLS = 4;            // grid cells of a patch
constexpr double LEAST_SUN_COSINE = .02;  // between the sun and the normal of a window or of the lit plane
constexpr double FULL = .7;               // lit fraction of a patch above which it is not cut

struct Cell {
    int a, b;  // cell of the grid
    Vec3 p;    // hit of its ray
};

struct LitPlane {
    Vec3 p, n;  // n: on the sun's side
    std::vector<Cell> cells;
};

struct Box {
    int lo[2] = {SIDE, SIDE}, hi[2] = {-1, -1};
    double cells() const { return hi[0] < lo[0] ? 0 : double(hi[0] - lo[0] + 1) * (hi[1] - lo[1] + 1); }
    void take(const Box& b) {
        for (int k = 0; k < 2; k++) {
            lo[k] = std::min(lo[k], b.lo[k]);
            hi[k] = std::max(hi[k], b.hi[k]);
        }
    }
    void take(const Cell& c) { take(Box{{c.a, c.b}, {c.a, c.b}}); }
};

struct Patch {
    Target target;
    double lit;  // area times the cosine of the sun
};

class WindowSearch {
public:
    WindowSearch(const flatten::HostTracer& tracer, const Target& window, Vec3 sun)
        : tracer_(tracer), window_(window), sun_(sun) {}

    void patches(std::vector<Patch>& found) {
        send();
        for (LitPlane& plane : planes_) cut(plane, plane.cells, found);
    }

private:
    const flatten::HostTracer& tracer_;
    const Target& window_;
    const Vec3 sun_;
    std::vector<LitPlane> planes_;

    Vec3 corner() const { return window_.centre - window_.u * .5 - window_.v * .5; }
    double cell_light() const { return length(cross(window_.u, window_.v)) * dot(window_.out, sun_) / (SIDE * SIDE); }

    void send() {
        const double off = 1e-4 * std::sqrt(length(cross(window_.u, window_.v)));
        for (int a = 0; a < SIDE; a++)
            for (int b = 0; b < SIDE; b++) {
                const Vec3 from = corner() + window_.u * ((a + .5) / SIDE) + window_.v * ((b + .5) / SIDE);
                if (tracer_.blocked(from, sun_, -off, 1e30, flatten::HostTracer::opaque)) continue;
                const flatten::HostTracer::Found met =
                    tracer_.closest(from, -sun_, off, 1e30, flatten::HostTracer::opaque);
                if (met.t < 0) continue;
                const Vec3 n = dot(met.normal, sun_) < 0 ? -met.normal : met.normal, p = from - sun_ * met.t;
                if (dot(n, sun_) >= LEAST_SUN_COSINE) plane_of(p, n).cells.push_back({a, b, p});
            }
    }

    LitPlane& plane_of(Vec3 p, Vec3 n) {
        for (LitPlane& plane : planes_)
            if (dot(plane.n, n) > .9999 && std::fabs(dot(p - plane.p, n)) < 1e-3 * (1 + length(p - plane.p)))
                return plane;
        planes_.push_back({p, n, {}});
        return planes_.back();
    }

    // Point on a plane that is lit through (a, b) of the window.
    Vec3 image(const LitPlane& plane, double a, double b) const {
        const Vec3 from = corner() + window_.u * (a / SIDE) + window_.v * (b / SIDE);
        return from - sun_ * (dot(from - plane.p, plane.n) / dot(sun_, plane.n));
    }

    // One patch around some cells of a plane, or two where it would be mostly dark.
    void cut(const LitPlane& plane, const std::vector<Cell>& cells, std::vector<Patch>& found) {
        if (cells.size() < LEAST_CELLS) return;
        Box box;
        for (const Cell& cell : cells) box.take(cell);
        int axis = 0, at = 0;
        double least = box.cells();
        if (double(cells.size()) < FULL * least) best_cut(box, cells, least, axis, at);
        if (at > 0) {
            std::vector<Cell> low, high;
            for (const Cell& cell : cells) ((axis == 0 ? cell.a : cell.b) < at ? low : high).push_back(cell);
            cut(plane, low, found);
            cut(plane, high, found);
            return;
        }
        const Vec3 p = image(plane, box.lo[0], box.lo[1]), u = image(plane, box.hi[0] + 1, box.lo[1]) - p,
                   v = image(plane, box.lo[0], box.hi[1] + 1) - p;
        found.push_back({{p + u * .5 + v * .5, u, v, -plane.n}, cell_light() * double(cells.size())});
    }

    // at: the cut along an axis that leaves two clearly smaller boxes in all; unchanged if there is none.
    static void best_cut(const Box& box, const std::vector<Cell>& cells, double least, int& axis, int& at) {
        least *= .85;
        for (int k = 0; k < 2; k++) {
            Box low, rows[SIDE], high[SIDE + 1];  // high: of a row and those after it
            for (const Cell& cell : cells) rows[k == 0 ? cell.a : cell.b].take(cell);
            for (int c = SIDE - 1; c >= 0; c--) (high[c] = rows[c]).take(high[c + 1]);
            for (int c = box.lo[k] + 1; c <= box.hi[k]; c++) {
                low.take(rows[c - 1]);
                if (!(low.cells() + high[c].cells() < least)) continue;
                least = low.cells() + high[c].cells();
                axis = k;
                at = c;
            }
        }
    }
};

}  // namespace

std::vector<Target> find_patches(const flatten::FlatScene& scene, const flatten::HostTracer& tracer,
                                 const std::vector<Target>& windows, size_t most) {
    std::vector<Patch> found;
    for (const Vec3& sun : suns_of(scene))
        for (const Target& window : windows)
            if (dot(window.out, sun) > LEAST_SUN_COSINE) WindowSearch(tracer, window, sun).patches(found);
    std::stable_sort(found.begin(), found.end(), [](const Patch& a, const Patch& b) { return a.lit > b.lit; });
    std::vector<Target> targets;
    for (const Patch& patch : found)
        if (targets.size() < most) targets.push_back(patch.target);
    return targets;
}

}  // namespace sampling
