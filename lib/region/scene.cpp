// SPDX-License-Identifier: BSD-3-Clause
// Coverage with a scene.  One ray through each pixel's centre tells what is seen there.  Pixels whose nine-pixel
// neighbourhood answers alike are in or out; the others are sampled: 9 x 9 points, and where two neighbouring points
// disagree the border between them is found by halving, so that a straight edge is right to about 1/500 of the pixel.
// A pixel that comes out partly covered has its neighbours sampled as well, so that thin things are followed.
// Nothing depends on threads or chance.
#include <algorithm>
#include <cmath>
#include <map>
#include <mutex>
#include <set>
#include <fmt/format.h>
#include "base/error.h"
#include "region/match.h"
#include "region/raster.h"

namespace region {
namespace {

constexpr int ROOM = 24;           // surfaces along a ray that are told apart
constexpr int GRID = 8;            // cells of a sampled pixel, along each side
constexpr int HALVINGS = 3;        // of a cell's edge, to find a border
constexpr int TILE = 16;           // pixels
constexpr double COINCIDE = 3e-4;  // of the distance: a region drawn on a surface is seen

// What one ray sees.
struct Sight {
    Point p;
    bool seen = false;          // the view has a ray here
    double begin = 0, end = 0;  // along p.dir from the eye: where the view begins, where something opaque ends it
    int n = 0;
    Crossing crossings[ROOM];  // t from the eye as well
};

class SceneRaster {
public:
    SceneRaster(const Prepared& prepared, const SceneView& eye, bool centre, image::MaskSet& set)
        : in_(prepared),
          space_(prepared.space),
          eye_(eye),
          centre_(centre),
          set_(set),
          nx_(space_.nx),
          ny_(space_.ny) {}

    void run() {
        resolve_names();
        look_at_centres();
        collect_tiles();
        Pyramid pyramid(space_);
        const size_t count = in_.regions.regions.size();
        std::vector<std::vector<uint32_t>> open(count);
        for_all(count, [&](size_t r) { walk(pyramid, r, open[r]); });
        refine(open);
    }

private:
    // ---- names ----
    void resolve_names() {
        matched_.resize(in_.regions.shapes.size());
        std::vector<std::string> all[2];
        for (int kind = 0; kind < 2; ++kind)
            for (const Shape& s : in_.regions.shapes) {
                if (s.kind != (kind ? Kind::modifier : Kind::surface)) continue;
                std::vector<char>& good = matched_[size_t(&s - in_.regions.shapes.data())];
                good.assign(eye_.surfaces(), 0);
                bool any = false;
                for (unsigned k = 0; k < eye_.surfaces(); ++k) {
                    if (kind) {
                        for (const std::string& name : eye_.modifier_names(k))
                            good[k] = good[k] || matches(s.text, name);
                    } else {
                        std::string name = eye_.surface_name(k);
                        good[k] = !name.empty() && matches(s.text, name);
                    }
                    any = any || good[k];
                }
                if (any) continue;
                if (all[kind].empty())
                    for (unsigned k = 0; k < eye_.surfaces(); ++k) {
                        if (!kind) all[0].push_back(eye_.surface_name(k));
                        else
                            for (const std::string& name : eye_.modifier_names(k)) all[1].push_back(name);
                    }
                std::sort(all[kind].begin(), all[kind].end());
                all[kind].erase(std::unique(all[kind].begin(), all[kind].end()), all[kind].end());
                base::fail(s.place,
                           fmt::format("no {} of the scene is called \"{}\"{}", kind ? "surface's modifier" : "surface",
                                       s.text, near_matches(s.text, all[kind])));
            }
    }

    // ---- rays ----
    Sight look(double x, double y) const {
        Sight s;
        const auto ray = space_.projector.ray(x / nx_, y / ny_);
        s.seen = bool(ray);
        if (!ray) return s;
        s.p = {ray->dir, x, y};
        if (space_.behind > 0) space_.point(x, y, s.p);
        s.begin = dot(ray->origin - space_.eye, s.p.dir);
        bool closed = false;
        s.n = eye_.look(ray->origin, ray->dir, ray->tmax, s.crossings, ROOM, closed);
        for (int i = 0; i < s.n; ++i) s.crossings[i].t += s.begin;
        s.end = closed && s.n ? s.crossings[s.n - 1].t : ray->tmax > 0 ? s.begin + ray->tmax : INFINITY;
        return s;
    }

    void look_at_centres() {
        dirs_.resize(size_t(nx_) * size_t(ny_));
        ends_.resize(dirs_.size());
        seen_.resize(dirs_.size());
        lists_.push_back({});  // 0: no ray
        std::mutex lock;
        std::map<std::vector<unsigned>, uint32_t> known;
        for_all(size_t(ny_), [&](size_t y) {
            std::map<std::vector<unsigned>, uint32_t> mine;
            std::vector<unsigned> list;
            for (int x = 0; x < nx_; ++x) {
                Sight s = look(x + .5, double(y) + .5);
                size_t i = y * size_t(nx_) + size_t(x);
                dirs_[i] = s.p.dir;
                ends_[i] = s.end;
                if (!s.seen) continue;
                list.clear();
                for (int k = 0; k < s.n; ++k) list.push_back(s.crossings[k].surface);
                auto found = mine.find(list);
                if (found == mine.end()) {
                    std::lock_guard<std::mutex> hold(lock);
                    auto global = known.find(list);
                    if (global == known.end()) {
                        global = known.emplace(list, uint32_t(lists_.size())).first;
                        lists_.push_back(list);
                    }
                    found = mine.emplace(list, global->second).first;
                }
                seen_[i] = found->second;
            }
        });
        // Does a list of surfaces answer a query?
        answers_.resize(matched_.size());
        for (size_t q = 0; q < matched_.size(); ++q) {
            if (matched_[q].empty()) continue;
            answers_[q].resize(lists_.size());
            for (size_t l = 0; l < lists_.size(); ++l)
                for (unsigned s : lists_[l]) answers_[q][l] = answers_[q][l] || matched_[q][s];
        }
    }

    void collect_tiles() {
        across_ = (nx_ + TILE - 1) / TILE;
        tiles_.resize(size_t(across_) * size_t((ny_ + TILE - 1) / TILE));
        for_all(tiles_.size(), [&](size_t t) {  // with a rim of one pixel
            int x0 = int(t) % across_ * TILE, y0 = int(t) / across_ * TILE;
            std::set<uint32_t> lists;
            for (int y = std::max(y0 - 1, 0); y <= std::min(y0 + TILE, ny_ - 1); ++y)
                for (int x = std::max(x0 - 1, 0); x <= std::min(x0 + TILE, nx_ - 1); ++x) lists.insert(seen_[at(x, y)]);
            tiles_[t].assign(lists.begin(), lists.end());
        });
    }

    // ---- in, out or open ----
    size_t at(int x, int y) const { return size_t(y) * size_t(nx_) + size_t(x); }  // y from the bottom
    const Shape& shape(int s) const { return in_.regions.shapes[size_t(s)]; }
    static bool in_space(Kind k) {
        return k == Kind::polygon3d || k == Kind::disc3d || k == Kind::box3d || k == Kind::sphere3d;
    }
    bool asks_scene(int node) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        if (n.op == 's') return in_space(shape(n.a).kind) || !matched_[size_t(n.a)].empty();
        return asks_scene(n.a) || (n.b >= 0 && asks_scene(n.b));
    }

    // As Prepared::value(), but 0 ("either") where only the scene can tell.
    double value(int node, const CellGeometry& g, const Cell& c) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        switch (n.op) {
        case 's': {
            if (!matched_[size_t(n.a)].empty()) return query_value(n.a, c);
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
                for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, nx_ - 1); ++x) take(seen_[at(x, y)]);
        } else {
            for (int y = c.y; y < std::min(c.y + c.size, ny_); y += TILE)
                for (int x = c.x; x < std::min(c.x + c.size, nx_); x += TILE)
                    for (uint32_t list : tiles_[size_t(y / TILE) * size_t(across_) + size_t(x / TILE)]) take(list);
        }
        if (!any) return -2;
        return all && shape(s).within < 0 ? 2 : 0;
    }
    // v: the shape's own value.  Seen at the nine centres alike, or open.
    double space_value(int s, const Cell& c, double v) const {
        if (c.size > 1) return 0;
        const Field& field = *in_.fields[size_t(s)];
        bool seen = false, hidden = false;
        for (int y = std::max(c.y - 1, 0); y <= std::min(c.y + 1, ny_ - 1); ++y)
            for (int x = std::max(c.x - 1, 0); x <= std::min(c.x + 1, nx_ - 1); ++x) {
                Point p{dirs_[at(x, y)], x + .5, y + .5};
                if (p.dir == Vec3{}) return 0;
                double d = field.distance(p);
                if (d < 0 || (d == 0 && v <= 2) || space_.projector.view().vo > 0) return 0;
                (visible(d, space_.behind, ends_[at(x, y)]) ? seen : hidden) = true;
            }
        if (seen && hidden) return 0;
        if (hidden) return -2;
        return v > 1 ? v : 0;
    }
    static bool visible(double d, double begin, double end) {
        double slack = COINCIDE * (std::min(end, std::max(d, begin)) - begin) + 1e-9;
        return d == 0 || (d >= begin - slack && d <= end + slack);
    }

    bool inside(int node, const Sight& s) const {
        const Node& n = in_.regions.nodes[size_t(node)];
        switch (n.op) {
        case 's': {
            const Shape& sh = shape(n.a);
            const std::vector<char>& good = matched_[size_t(n.a)];
            if (!good.empty()) {
                for (int i = 0; i < s.n; ++i) {
                    if (!good[s.crossings[i].surface]) continue;
                    if (sh.within < 0) return true;
                    if (in_.fields[size_t(sh.within)]->contains(space_.eye + s.p.dir * s.crossings[i].t)) return true;
                }
                return false;
            }
            const Field& f = *in_.fields[size_t(n.a)];
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
                     [&](int x, int y, const CellGeometry&) { open.push_back(uint32_t(at(x, y))); });
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
                            if (asked[t.region][at(X, Y)]) continue;
                            asked[t.region][at(X, Y)] = true;
                            next.push_back({uint32_t(at(X, Y)), t.region});
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
            Sight s = look(x + .5, y + .5);
            for (const Task* t = first; t < last; ++t)
                *coverage(*t) = s.seen && inside(in_.regions.regions[t->region].root, s);
            return;
        }
        std::vector<Sight> sights((GRID + 1) * (GRID + 1));
        for (int j = 0; j <= GRID; ++j)
            for (int i = 0; i <= GRID; ++i)
                sights[size_t(j * (GRID + 1) + i)] = look(x + double(i) / GRID, y + double(j) / GRID);
        for (const Task* t = first; t < last; ++t)
            *coverage(*t) = float(share(in_.regions.regions[t->region].root, x, y, sights));
    }
    double share(int root, double x, double y, const std::vector<Sight>& sights) const {
        bool in[GRID + 1][GRID + 1];
        int count = 0;
        for (int j = 0; j <= GRID; ++j)
            for (int i = 0; i <= GRID; ++i) {
                const Sight& s = sights[size_t(j * (GRID + 1) + i)];
                count += in[j][i] = s.seen && inside(root, s);
            }
        if (count == 0 || count == (GRID + 1) * (GRID + 1)) return count > 0;
        // Border on the edge from grid point (i, j) to its right (upper) neighbour, as a share of the edge; each once.
        double right[GRID + 1][GRID], above[GRID][GRID + 1];
        auto border = [&](double X, double Y, double dx, double dy, bool from) {
            double a = 0, b = 1;
            for (int k = 0; k < HALVINGS; ++k) {
                double m = (a + b) / 2;
                Sight s = look(x + (X + m * dx) / GRID, y + (Y + m * dy) / GRID);
                ((s.seen && inside(root, s)) == from ? a : b) = m;
            }
            return (a + b) / 2;
        };
        for (int j = 0; j <= GRID; ++j)
            for (int i = 0; i <= GRID; ++i) {
                if (i < GRID && in[j][i] != in[j][i + 1]) right[j][i] = border(i, j, 1, 0, in[j][i]);
                if (j < GRID && in[j][i] != in[j + 1][i]) above[j][i] = border(i, j, 0, 1, in[j][i]);
            }
        double sum = 0;
        for (int j = 0; j < GRID; ++j)
            for (int i = 0; i < GRID; ++i) {
                // Around the cell: corners and, on edges between unlike corners, borders.
                const bool c[4] = {in[j][i], in[j][i + 1], in[j + 1][i + 1], in[j + 1][i]};
                const int n = c[0] + c[1] + c[2] + c[3];
                if (n == 0 || n == 4) {
                    sum += n / 4;
                    continue;
                }
                const double corner[4][2] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
                double edge[4][2] = {{0, 0}, {1, 0}, {0, 1}, {0, 0}};
                if (c[0] != c[1]) edge[0][0] = right[j][i];
                if (c[1] != c[2]) edge[1][1] = above[j][i + 1];
                if (c[2] != c[3]) edge[2][0] = right[j + 1][i];
                if (c[3] != c[0]) edge[3][1] = above[j][i];
                if (n == 2 && c[0] == c[2]) {  // a saddle: the middle tells which pair of corners is joined
                    Sight s = look(x + (i + .5) / GRID, y + (j + .5) / GRID);
                    const bool middle = s.seen && inside(root, s),
                               low = c[0] != middle;  // the corners that are cut off
                    double cut = low ? edge[0][0] * edge[3][1] + (1 - edge[1][1]) * (1 - edge[2][0])
                                     : (1 - edge[0][0]) * edge[1][1] + edge[2][0] * (1 - edge[3][1]);
                    sum += middle ? 1 - cut / 2 : cut / 2;
                    continue;
                }
                double px[8], py[8], area = 0;
                int m = 0;
                for (int k = 0; k < 4; ++k) {
                    if (c[k]) px[m] = corner[k][0], py[m++] = corner[k][1];
                    if (c[k] != c[(k + 1) % 4]) px[m] = edge[k][0], py[m++] = edge[k][1];
                }
                for (int k = 0; k < m; ++k) area += px[k] * py[(k + 1) % m] - px[(k + 1) % m] * py[k];
                sum += area / 2;
            }
        return sum / (GRID * GRID);
    }

    const Prepared& in_;
    const Space& space_;
    const SceneView& eye_;
    bool centre_;
    image::MaskSet& set_;
    int nx_, ny_, across_ = 0;
    std::vector<std::vector<char>> matched_;    // by shape: does it ask for this surface?
    std::vector<std::vector<unsigned>> lists_;  // the different lists of surfaces that rays met
    std::vector<std::vector<char>> answers_;    // by shape and list
    std::vector<Vec3> dirs_;                    // of the pixels' centres, rows from the bottom
    std::vector<double> ends_;
    std::vector<uint32_t> seen_;                // list of each centre
    std::vector<std::vector<uint32_t>> tiles_;  // lists seen in each tile
};

}  // namespace

void rasterize_scene(const Prepared& prepared, const SceneView& eye, bool centre, image::MaskSet& set) {
    SceneRaster(prepared, eye, centre, set).run();
}

}  // namespace region
