// SPDX-License-Identifier: BSD-3-Clause
// Images of the sun in curved surfaces.  A path that leaves the scene at an angle e to the sun, its place in the
// picture being p, is followed by halving steps to where |e| is least.  Starts: places of a net where e changes to the
// next one by as much as it is itself, or where the surface ends.
#include "render/sun_images.h"

#include "flatten/pack.h"
#include "render/image_tracer.h"

namespace render {
using namespace kernels;
using base::Vec3;

namespace {

constexpr uint32_t PICTURE_NET = 192, BALL_NET = 16;  // places a side
constexpr uint32_t WAYS = 8;                          // at three surfaces a path can go two ways
constexpr size_t MOST_STARTS = 512;
constexpr int STEPS = 22;    // of halving: from a cell of the net to the rounding of its directions
constexpr int STENCIL = 5;   // places a side around the best one
constexpr double LEFT = .3;  // what all ways have for further surfaces, so that neighbours take the same

struct Start {
    double X, Y, cell;  // side of a cell of its net
    uint32_t way;
    double e, change;  // |e|, and its change to the neighbours
    double cells_to_root() const { return e / change; }
};

class Search {
public:
    Search(device::Device& device, const device::Params& base, const view::View& view, Vec3 sun, double radius)
        : all_(device, base, view, WAYS), one_(device, base, view, 1), sun_(sun), radius_(radius) {
        all_.seek_directions(), one_.seek_directions();
    }

    void find(const std::vector<sampling::Ball>& balls, Vec3 eye, SunImages& images) {
        std::vector<Start> starts = look_around(balls, eye);
        std::vector<Start> met;
        for (int i = 0; i < STEPS && !starts.empty(); i++) {
            const double size = std::pow(2, -i);  // of the cells
            step(starts, .5 * size);
            std::vector<Start> left;
            for (const Start& s : starts)
                if (s.e < .2 * radius_) met.push_back(s);
                else if (s.e < 8 * s.change * size || s.e < radius_) left.push_back(s);
            starts = std::move(left);
        }
        for (const Start& s : starts)
            if (s.e < radius_) met.push_back(s);
        measure(met, images);
    }

private:
    // Sets e to the difference of a path's end from the sun's direction.  False: it has no specular end in the sky.
    bool difference(const ImageTracer& tracer, size_t place, uint32_t way, Vec3& e) const {
        const float* d = tracer.of(place, way);
        const Vec3 dir{d[0], d[1], d[2]};
        e = dir - sun_;
        return dot(dir, dir) > .5;
    }

    // A square of the picture, about (X, Y), with n x n places.
    struct Net {
        double X, Y, side;
        uint32_t n;
        double x_of(uint32_t i) const { return X + ((i % n + .5) / n - .5) * side; }
        double y_of(uint32_t i) const { return Y + ((i / n + .5) / n - .5) * side; }
    };

    std::vector<Start> look_around(const std::vector<sampling::Ball>& balls, Vec3 eye) {
        std::vector<Net> nets{{.5, .5, 1, PICTURE_NET}};
        for (const sampling::Ball& ball : balls) {
            const double d = length(ball.centre - eye);
            double X, Y;
            if (d <= ball.radius || !all_.projector().locate_direction(unit(ball.centre - eye), X, Y)) continue;
            const auto place = place_of(all_.projector(), unit(ball.centre - eye), 1, 1, true);
            if (place) nets.push_back({X, Y, 2.5 * ball.radius / d / std::sqrt(place->sr), BALL_NET});
        }
        size_t places = 0;
        for (const Net& net : nets) places += size_t(net.n) * net.n;
        all_.reserve(places);
        for (const Net& net : nets)
            for (uint32_t i = 0; i < net.n * net.n; i++) all_.add(net.x_of(i), net.y_of(i), LEFT);
        all_.run(0);
        std::vector<Start> starts;
        size_t first = 0;
        for (const Net& net : nets) {
            for (uint32_t i = 0; i < net.n * net.n; i++)
                for (uint32_t way = 0; way < WAYS; way++) add_start(net, first, i, way, starts);
            first += size_t(net.n) * net.n;
        }
        std::stable_sort(starts.begin(), starts.end(),
                         [](auto& a, auto& b) { return a.cells_to_root() < b.cells_to_root(); });
        if (starts.size() > MOST_STARTS) starts.resize(MOST_STARTS);
        return starts;
    }

    void add_start(const Net& net, size_t first, uint32_t i, uint32_t way, std::vector<Start>& starts) const {
        Vec3 e, other;
        const int n = int(net.n);
        if (!difference(all_, first + i, way, e)) return;
        double change = 0;
        for (int k = 0; k < 4; k++) {
            const int x = int(i) % n + (k < 2 ? 2 * k - 1 : 0), y = int(i) / n + (k < 2 ? 0 : 2 * k - 5);
            if (x < 0 || y < 0 || x >= n || y >= n) continue;
            const bool ends = !difference(all_, first + size_t(y) * net.n + size_t(x), way, other);
            change = std::max(change, ends ? 2 : length(other - e));
        }
        if (length(e) < 2 * change) starts.push_back({net.x_of(i), net.y_of(i), net.side / n, way, length(e), change});
    }

    // Moves each to the best of the places around it, `part` of its cell apart.
    void step(std::vector<Start>& starts, double part) {
        one_.clear();
        const auto offset = [&](const Start& s, int k) { return (k - STENCIL / 2) * part * s.cell; };
        for (const Start& s : starts)
            for (int k = 0; k < STENCIL * STENCIL; k++)
                add_one(s.X + offset(s, k % STENCIL), s.Y + offset(s, k / STENCIL), s.way);
        one_.run(0);
        for (size_t i = 0; i < starts.size(); i++) {
            Start& s = starts[i];
            const Start from = s;
            for (int k = 0; k < STENCIL * STENCIL; k++) {
                Vec3 e;
                if (!difference(one_, i * STENCIL * STENCIL + size_t(k), 0, e) || !(length(e) < s.e)) continue;
                s.e = length(e);
                s.X = from.X + offset(s, k % STENCIL), s.Y = from.Y + offset(s, k / STENCIL);
            }
        }
    }

    void add_one(double X, double Y, uint32_t way) { one_.add(X, Y, (way + LEFT) / WAYS); }

    // Adds a disc about each place that has met the sun: as large as the largest of a row of circles, of 16 camera
    // directions each, on which the sun is met.
    void measure(const std::vector<Start>& starts, SunImages& images) {
        constexpr int circles = 48, around = 16;
        const auto angle_of = [&](int circle) { return 2 * radius_ * std::pow(.75, circle); };
        std::vector<std::pair<Vec3, uint32_t>> met;
        one_.clear();
        for (const Start& s : starts) {
            const auto dir = one_.projector().direction(s.X, s.Y);
            if (!dir || met.size() >= MOST_IMAGES || is_listed(*dir, images)) continue;
            if (std::any_of(met.begin(), met.end(), [&](auto& m) { return length(m.first - *dir) < 2e-6; })) continue;
            met.push_back({*dir, s.way});
            const Vec3 a = unit(cross(*dir, std::fabs(dir->x) < .5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0})),
                       b = cross(*dir, a);
            for (int k = 0; k < circles * around; k++) {
                const double turn = 2 * M_PI * (k % around) / around, h = angle_of(k / around);
                double X = -1, Y = -1;
                one_.projector().locate_direction(unit(*dir + a * (h * std::cos(turn)) + b * (h * std::sin(turn))), X,
                                                  Y);
                add_one(X, Y, s.way);
            }
        }
        one_.run(0);
        for (size_t i = 0; i < met.size(); i++) {
            Vec3 e;
            int circle = 0;
            const auto meets_sun = [&](int k) {
                return difference(one_, (i * circles + size_t(circle)) * around + size_t(k), 0, e) &&
                       length(e) < radius_;
            };
            const auto meets = [&] {
                for (int k = 0; k < around; k++)
                    if (meets_sun(k)) return true;
                return false;
            };
            while (circle < circles - 1 && !meets()) circle++;
            const double angle = 1.5 * angle_of(circle);
            if (!is_listed(met[i].first, images)) images.discs.push_back({met[i].first, angle * angle / 2});
        }
    }

    static bool is_listed(Vec3 dir, const SunImages& images) {
        return std::any_of(images.discs.begin(), images.discs.end(), [&](const SunImages::Disc& d) {
            const Vec3 e = dir - d.dir;
            return dot(e, e) / 2 <= d.cap;
        });
    }

    ImageTracer all_, one_;
    Vec3 sun_;
    double radius_;
};

}  // namespace

void find_curved_images(device::Device& device, const device::Params& base, const flatten::FlatScene& scene,
                        const sampling::SmoothSurfaces& smooth, const view::View& view, SunImages& images) {
    for (const uint32_t i : images.sources) {
        const Source& q = scene.sources[i];
        const double radius = std::acos(1 - double(q.cap));
        Search(device, base, view, unit(flatten::vec_of(q.centre)), radius).find(smooth.balls, view.vp, images);
    }
}

}  // namespace render
