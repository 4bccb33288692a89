// SPDX-License-Identifier: BSD-3-Clause
// Coverage with a scene.  One ray through each pixel's centre tells what is seen there.  Pixels whose nine-pixel
// neighbourhood answers alike are in or out; the others are sampled: 9 x 9 points, and where two neighbouring points
// disagree the border between them is found by halving, so that a straight edge is right to about 1/500 of the pixel.
// A pixel that comes out partly covered has its neighbours sampled as well, so that thin things are followed.
// Nothing depends on threads or chance.
#include <algorithm>
#include "region/border.h"
#include "region/queries.h"
#include "region/raster.h"
#include "region/pixel_visibility.h"

namespace region {
namespace {

constexpr double coincide = 3e-4;  // of the distance: a region drawn on a surface is seen

class SceneRaster {
public:
    SceneRaster(const Prepared& prepared, const SceneView& eye, bool centre, image::MaskSet& set)
        : in_(prepared),
          space_(prepared.space),
          centre_(centre),
          set_(set),
          nx_(space_.nx),
          ny_(space_.ny),
          meant_(meant_surfaces(prepared.regions, eye)),
          visibility_(space_, eye) {}

    void run() {
        answer_queries();
        Pyramid pyramid(space_);
        const size_t count = in_.regions.regions.size();
        std::vector<std::vector<uint32_t>> open(count);
        for_all(count, [&](size_t r) { walk(pyramid, r, open[r]); });
        refine(open);
    }

private:
    // Does a list of surfaces answer a query?
    void answer_queries() {
        const std::vector<std::vector<unsigned>>& lists = visibility_.lists();
        answers_.resize(meant_.size());
        for (size_t q = 0; q < meant_.size(); ++q) {
            if (meant_[q].empty()) continue;
            answers_[q].resize(lists.size());
            for (size_t l = 0; l < lists.size(); ++l)
                for (unsigned s : lists[l]) answers_[q][l] = answers_[q][l] || meant_[q][s];
        }
    }

    // ---- in, out or open ----
    const Shape& shape(int s) const { return in_.regions.shapes[size_t(s)]; }
    static bool in_space(Kind k) {
        return k == Kind::polygon3d || k == Kind::disc3d || k == Kind::box3d || k == Kind::sphere3d;
    }
    bool asks_scene(int node) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        if (n.op == 's') return in_space(shape(n.a).kind) || !meant_[size_t(n.a)].empty();
        return asks_scene(n.a) || (n.b >= 0 && asks_scene(n.b));
    }

    // As Prepared::value(), but 0 ("either") where only the scene can tell.
    double value(int node, const CellGeometry& g, const Cell& c) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        switch (n.op) {
        case 's': {
            if (!meant_[size_t(n.a)].empty()) return query_value(n.a, c);
            if (g.centre.dir == Vec3{}) return 0;
            double v = in_.value(node, g.centre, g.reach);
            return v >= -1 && in_space(shape(n.a).kind) ? space_value(n.a, c, v) : v;
        }
        case '+': return std::max(value(n.a, g, c), value(n.b, g, c));
        case '&': return std::min(value(n.a, g, c), value(n.b, g, c));
        case '-': return std::min(value(n.a, g, c), -value(n.b, g, c));
        default: return std::min(-value(n.a, g, c), g.centre.dir == Vec3{} ? 0 : in_.view_field(g.centre, g.reach));
        }
    }
    double query_value(int s, const Cell& c) const {
        const std::vector<char>& answer = answers_[size_t(s)];
        bool all = true, any = false;
        auto take = [&](uint32_t list) {
            all = all && answer[list];
            any = any || answer[list];
        };
        if (c.size == 1) {
            for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, ny_ - 1); ++y)
                for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, nx_ - 1); ++x) take(visibility_.list(x, y));
        } else {
            for (int y = c.y; y < std::min(c.y + c.size, ny_); y += PixelVisibility::tile)
                for (int x = c.x; x < std::min(c.x + c.size, nx_); x += PixelVisibility::tile)
                    for (uint32_t list : visibility_.lists_in_tile(x, y)) take(list);
        }
        if (!any) return -2;
        return all && shape(s).within < 0 ? 2 : 0;
    }
    // v: the shape's own value.  Seen at the nine centres alike, or open.
    double space_value(int s, const Cell& c, double v) const {
        if (c.size > 1) return 0;
        const Field& field = in_.fields[size_t(s)];
        bool seen = false, hidden = false;
        for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, ny_ - 1); ++y)
            for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, nx_ - 1); ++x) {
                Point p{visibility_.direction(x, y), x + .5, y + .5};
                if (p.dir == Vec3{}) return 0;
                double d = field.distance(p);
                if (d < 0 || (d == 0 && v <= 2) || space_.projector.view().vo > 0) return 0;
                (visible(d, space_.behind, visibility_.end(x, y)) ? seen : hidden) = true;
            }
        if (seen && hidden) return 0;
        if (hidden) return -2;
        return v > 1 ? v : 0;
    }
    static bool visible(double d, double begin, double end) {
        double slack = coincide * (std::min(end, std::max(d, begin)) - begin) + 1e-9;
        return d == 0 || (d >= begin - slack && d <= end + slack);
    }

    bool inside(int node, const RayHits& s) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        switch (n.op) {
        case 's': {
            const Shape& sh = shape(n.a);
            const std::vector<char>& good = meant_[size_t(n.a)];
            if (!good.empty()) {
                for (int i = 0; i < s.n; ++i) {
                    if (!good[s.crossings[i].surface]) continue;
                    if (sh.within < 0) return true;
                    if (in_.fields[size_t(sh.within)].contains(space_.eye + s.p.dir * s.crossings[i].t)) return true;
                }
                return false;
            }
            const Field& f = in_.fields[size_t(n.a)];
            return f.value(s.p) >= 0 && (!in_space(sh.kind) || visible(f.distance(s.p), s.begin, s.end));
        }
        case '+': return inside(n.a, s) || inside(n.b, s);
        case '&': return inside(n.a, s) && inside(n.b, s);
        case '-': return inside(n.a, s) && !inside(n.b, s);
        default: return !inside(n.a, s) && in_.view_field(s.p, {1, 1}) >= 0;
        }
    }

    void walk(const Pyramid& pyramid, size_t r, std::vector<uint32_t>& open) {
        const int root = in_.regions.regions[r].root;
        std::vector<float>& plane = set_.masks[r].coverage;
        if (!asks_scene(root)) {
            rasterize_plain(in_, pyramid, r, centre_, plane);
            return;
        }
        plane.assign(size_t(nx_) * size_t(ny_), 0.f);
        pyramid.walk([&](const CellGeometry& g, const Cell& c) { return value(root, g, c); },
                     [&](const Cell& c, bool in) {
                         if (in) fill(plane, space_, c, 1);
                     },
                     [&](int x, int y, const CellGeometry&) { open.push_back(uint32_t(visibility_.at(x, y))); });
    }

    // ---- open pixels ----
    struct Task {
        uint32_t pixel, region;
    };
    void refine(const std::vector<std::vector<uint32_t>>& open) {
        std::vector<Task> tasks;
        std::vector<std::vector<bool>> asked(open.size());
        for (size_t r = 0; r < open.size(); ++r) {
            if (open[r].empty()) continue;
            asked[r].resize(size_t(nx_) * size_t(ny_));
            for (uint32_t p : open[r]) asked[r][p] = true, tasks.push_back({p, uint32_t(r)});
        }
        while (!tasks.empty()) {
            std::sort(tasks.begin(), tasks.end(),
                      [](Task a, Task b) { return a.pixel != b.pixel ? a.pixel < b.pixel : a.region < b.region; });
            std::vector<size_t> starts;  // of each pixel's tasks
            for (size_t i = 0; i < tasks.size(); ++i)
                if (i == 0 || tasks[i].pixel != tasks[i - 1].pixel) starts.push_back(i);
            starts.push_back(tasks.size());
            for_all((starts.size() + 62) / 64, [&](size_t block) {
                for (size_t k = 64 * block; k < std::min(64 * block + 64, starts.size() - 1); ++k)
                    sample(&tasks[starts[k]], &tasks[0] + starts[k + 1]);
            });
            std::vector<Task> next;
            if (!centre_)
                for (const Task& t : tasks) {
                    int x = int(t.pixel) % nx_, y = int(t.pixel) / nx_;
                    float c = *coverage(t);
                    if (c <= 0 || c >= 1) continue;
                    for (int Y = std::max(y - 1, 0); Y <= std::min(y + 1, ny_ - 1); ++Y)
                        for (int X = std::max(x - 1, 0); X <= std::min(x + 1, nx_ - 1); ++X) {
                            if (asked[t.region][visibility_.at(X, Y)]) continue;
                            asked[t.region][visibility_.at(X, Y)] = true;
                            next.push_back({uint32_t(visibility_.at(X, Y)), t.region});
                        }
                }
            tasks.swap(next);
        }
    }
    float* coverage(const Task& t) const {
        size_t x = t.pixel % size_t(nx_), y = t.pixel / size_t(nx_);
        return &set_.masks[t.region].coverage[(size_t(ny_) - 1 - y) * size_t(nx_) + x];
    }

    // All tasks of one pixel share its rays.
    void sample(const Task* first, const Task* last) const {
        const double x = first->pixel % uint32_t(nx_), y = first->pixel / uint32_t(nx_);
        if (centre_) {
            RayHits s = visibility_.trace(x + .5, y + .5);
            for (const Task* t = first; t < last; ++t)
                *coverage(*t) = s.seen && inside(in_.regions.regions[t->region].root, s);
            return;
        }
        std::vector<RayHits> ray_hits;
        for (int j = 0; j <= border_cells; ++j)
            for (int i = 0; i <= border_cells; ++i)
                ray_hits.push_back(visibility_.trace(x + double(i) / border_cells, y + double(j) / border_cells));
        for (const Task* t = first; t < last; ++t)
            *coverage(*t) = float(share(in_.regions.regions[t->region].root, x, y, ray_hits));
    }
    double share(int root, double x, double y, const std::vector<RayHits>& ray_hits) const {
        const auto in_region = [&](const RayHits& s) { return s.seen && inside(root, s); };
        BorderSamples in;
        for (int j = 0; j <= border_cells; ++j)
            for (int i = 0; i <= border_cells; ++i) in[j][i] = in_region(ray_hits[size_t(j * (border_cells + 1) + i)]);
        return share_inside(in, [&](double u, double v) { return in_region(visibility_.trace(x + u, y + v)); });
    }

    const Prepared& in_;
    const Space& space_;
    bool centre_;
    image::MaskSet& set_;
    int nx_, ny_;
    std::vector<std::vector<char>> meant_;  // by shape: does it ask for this surface?
    PixelVisibility visibility_;
    std::vector<std::vector<char>> answers_;  // by shape and list of surfaces
};

}  // namespace

void rasterize_scene(const Prepared& prepared, const SceneView& eye, bool centre, image::MaskSet& set) {
    SceneRaster(prepared, eye, centre, set).run();
}

}  // namespace region
