// SPDX-License-Identifier: BSD-3-Clause
// See sensor_starts.h.
#include "render/sensor_starts.h"

#include <algorithm>
#include <cmath>

#include "base/processors.h"
#include "base/threads.h"
#include "flatten/host_tracer.h"

namespace render {
using base::Vec3;

namespace {

constexpr double FTINY = 1e-6;      // RADIANCE's: a ray does not meet what is nearer
constexpr double AHEAD = 1e-4;      // a sensor of rtrace -I begins so far along its direction
constexpr double ALONG = 1e-4;      // cosine below which a sensor looks along a surface: it sees both sides, as there
constexpr double PLANE_SHARE = .3;  // of the rounding, the part by which a surface's own place may be wrong
constexpr int MOST_HITS = 16;       // along a line

struct Near {
    uint32_t prim, inst;
    Vec3 normal, place;
    double clearance, unsure;
};

// A plane across an axis is as exact as its one coordinate, however large it is.
double rounding_of(const flatten::FlatScene& scene, const flatten::HostTracer::Found& f) {
    const bool flat = (scene.prims[f.prim].kind & PRIM_KIND_MASK) == PRIM_FLAT && f.inst == NONE;
    const Vec3 n = f.normal, p = f.place - scene.centre;
    for (int k = 0; k < 3; k++)
        if (flat && std::fabs(n[k]) == 1) return double(SURFACE_ROUNDING) * std::fabs(p[k]);
    return f.rounding;
}

class Starts {
public:
    explicit Starts(const flatten::FlatScene& scene) : scene_(scene), tracer_(scene) {}

    Vec3 start(const image::Point& sensor) const {
        Vec3 p = sensor.p;
        const std::vector<Near> all = surfaces_around(sensor);
        for (int round = 0; round < 2; round++)  // again: a second surface may bring it back to the first
            for (const Near& s : all) {
                const double height = dot(sensor.p - s.place, s.normal), ahead = dot(sensor.dir, s.normal);
                const bool on = std::fabs(height) <= std::max(s.unsure, AHEAD * std::fabs(ahead));
                if (on && std::fabs(ahead) < ALONG) continue;
                const double side = (on ? ahead : height) > 0 ? 1 : -1;
                const double now = side * dot(p - s.place, s.normal);
                if (now < s.clearance) p = p + s.normal * (side * (s.clearance - now));
            }
        return p;
    }

private:
    const flatten::FlatScene& scene_;
    const flatten::HostTracer tracer_;

    // The surfaces on which it may lie, the surest last: of short lines through it, one crosses each.
    std::vector<Near> surfaces_around(const image::Point& sensor) const {
        const Vec3 p = sensor.p - scene_.centre;
        const double size = scene_.radius + std::fabs(p.x) + std::fabs(p.y) + std::fabs(p.z);
        const double reach = std::ldexp(size, -18) + 2 * AHEAD;  // well above the rounding of what is not huge
        std::vector<Near> all;
        const Vec3 lines[] = {sensor.dir, {1, 0, 0},  {0, 1, 0},  {0, 0, 1},
                              {1, 1, 1},  {1, 1, -1}, {1, -1, 1}, {-1, 1, 1}};
        for (const Vec3& line : lines) add(sensor.p, base::unit(line), reach, all);
        std::sort(all.begin(), all.end(), [](const Near& a, const Near& b) { return a.clearance > b.clearance; });
        return all;
    }
    void add(Vec3 p, Vec3 dir, double reach, std::vector<Near>& all) const {
        double from = 0;
        for (int k = 0; k < MOST_HITS; k++) {
            const auto f = tracer_.closest(p - dir * reach, dir, from, 2 * reach, flatten::HostTracer::all);
            if (f.t < 0) return;
            from = f.t * (1 + 1e-6) + 1e-3 * FTINY;
            const double rounding = rounding_of(scene_, f), clearance = rounding + FTINY;
            const auto same = [&](const Near& s) { return s.prim == f.prim && s.inst == f.inst; };
            const bool near = std::fabs(dot(p - f.place, f.normal)) < std::max(clearance, AHEAD);
            if (near && std::none_of(all.begin(), all.end(), same))
                all.push_back({f.prim, f.inst, f.normal, f.place, clearance, PLANE_SHARE * rounding + FTINY});
        }
    }
};

}  // namespace

std::vector<Vec3> sensor_starts(const std::vector<image::Point>& sensors, const flatten::FlatScene& scene) {
    constexpr size_t share = 256;
    const Starts starts(scene);
    std::vector<Vec3> out(sensors.size());
    base::in_shares(sensors.size(), share, base::processors(), [&](size_t from, size_t end) {
        for (size_t i = from; i < end; i++) out[i] = starts.start(sensors[i]);
    });
    return out;
}

}  // namespace render
