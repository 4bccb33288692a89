// SPDX-License-Identifier: BSD-3-Clause
// Virtual sources: every active source mirrored in every flat mirror that it faces, or bent by every prism, and their
// images again, up to -dr levels (spec shading 3.18, 4.6).  A shadow ray aimed at one must hit the relay, then the real
// source.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "flatten/evaluate.h"
#include "flatten/sources.h"

namespace flatten {
namespace {
using Relay = Lights::Relay;
using Apertures = std::vector<Aperture>;

constexpr size_t MOST = 4096;

// Affine map of a source to its virtual position: p + (p.n - offset) h, then the mirror in the plane if requested.
struct Projection {
    Vec3 n, h;
    double offset = 0;
    bool mirrored = false;
    Vec3 vector(Vec3 v) const {
        v = v + h * dot(v, n);
        return mirrored ? v - n * (2 * dot(v, n)) : v;
    }
    Vec3 point(Vec3 p) const {
        p = p + h * (dot(p, n) - offset);
        return mirrored ? p - n * (2 * (dot(p, n) - offset)) : p;
    }
};

// Apertures of a source seen through one more relay: its own, then those behind it as a mirror shows them.  Through a
// prism they are unknown.
Apertures seen_apertures(const Apertures& behind, const Relay& r, const Projection& m) {
    Apertures apertures{r.aperture};
    if (r.exits) return apertures;
    for (const Aperture& g : behind)
        apertures.push_back({m.point(g.centre), m.vector(g.normal), m.vector(g.u), m.vector(g.v), g.both_sides});
    return apertures;
}

void append(std::vector<kernels::Aperture>& out, const Apertures& apertures) {
    for (const Aperture& g : apertures)
        out.push_back({packed(g.centre), packed(g.normal), packed(g.u), packed(g.v), g.both_sides});
}

// A prism shears the image: spheres and suns get axes that can be sheared (spec shading 4.3).
void give_axes(Source& q, bool distant) {
    if (q.sheared != 0) return;
    q.sheared = 1;
    const Vec3 c = vec_of(q.centre);
    const double half = distant ? std::sqrt(q.area) / 2 : .7236 * q.radius;
    const Vec3 u = distant ? unit(cross(c, std::fabs(c.z) < .9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0})) : Vec3{1, 0, 0};
    const Vec3 v = distant ? cross(c, u) : Vec3{0, 1, 0};
    q.u = packed(u * half);
    q.v = packed(v * half);
    q.normal = packed(distant ? Vec3() : Vec3{0, 0, half});
}

bool mirror_projection(const Relay& r, const Source& q, Projection& m) {
    m = {r.normal, {}, dot(r.normal, r.centre), true};
    const Vec3 c = vec_of(q.centre);
    // the source, at least its extreme point, must be in front of the mirror
    const double reach = q.kind == SK_CYLINDER ? q.radius + length(vec_of(q.u)) : q.radius;
    return q.kind == SK_DISTANT ? dot(c, m.n) + reach > 0 : dot(c, m.n) - m.offset + reach > 1e-6;
}

// A test ray from the source through the middle of the panel gives the prism's deflection (spec shading 3.18).
bool prism_projection(const FlatScene& scene, const Relay& r, uint32_t exit, const Source& q, Projection& m) {
    const bool distant = q.kind == SK_DISTANT;
    const Vec3 c = vec_of(q.centre), d0 = distant ? -c : unit(r.centre - c);
    const RayVars vars = ray_vars(scene, r.centre, d0, r.normal);
    float v[16];
    if (!run_program(scene, scene.modifiers[r.material].program, vars.values, v)) return false;
    const float* e = v + 4 * exit;
    Vec3 d1{e[1], e[2], e[3]};
    if (e[0] <= 1e-6f || length(d1) <= 1e-6) return false;
    d1 = unit(d1);
    const double a = dot(d0, r.normal), b = dot(d1, r.normal);
    if (std::fabs(a) <= 1e-6 || std::fabs(b) <= 1e-6) return false;
    m = {r.normal, d1 * (1 / b) - d0 * (1 / a), dot(r.normal, r.centre), (a > 0) != (b > 0)};
    return m.mirrored || length(m.h) > 1e-6;
}

// Moves the record to its virtual position.
void project(const Projection& m, bool by_prism, Source& q) {
    const bool distant = q.kind == SK_DISTANT, sphere = q.kind == SK_SPHERE;
    const Vec3 c = vec_of(q.centre);
    if (by_prism && (distant || sphere)) give_axes(q, distant);
    q.centre = packed(distant ? unit(m.vector(c)) : m.point(c));
    const double scale = distant ? 1 / length(m.vector(c)) : 1;
    for (Packed3* way : {&q.u, &q.v, &q.normal, &q.spot}) *way = packed(m.vector(vec_of(*way)) * scale);
    if (IS_SPOT(&q)) q.spot = packed(unit(vec_of(q.spot)));
    if (!sphere && !distant) q.normal = packed(unit(vec_of(q.normal)));
}

// Gives a general polygon triangles of its own.
void project_fan(const Projection& m, std::vector<FanTriangle>& fans, Source& q) {
    const uint32_t first = q.fan_at;
    q.fan_at = uint32_t(fans.size());
    for (uint32_t k = 0; k < q.fan_count; k++) {
        FanTriangle triangle = fans[first + k];
        triangle.corner = packed(m.point(vec_of(triangle.corner)));
        triangle.edge1 = packed(m.vector(vec_of(triangle.edge1)));
        triangle.edge2 = packed(m.vector(vec_of(triangle.edge2)));
        fans.push_back(triangle);
    }
}

class VirtualSources {
public:
    VirtualSources(FlatScene& out, Sources& sources)
        : out_(out), sources_(sources), last_relay_(sources.count(), NONE), apertures_(sources.count()) {}

    bool full() const { return last_relay_.size() >= MOST; }

    // Adds source i seen in a relay; false if the relay does not show it.
    bool add(uint32_t i, const Relay& r, uint32_t exit) {
        if (last_relay_[i] == r.prim) return false;
        Source q = sources_.records[i];
        Projection m;
        if (!(r.exits ? prism_projection(out_, r, exit, q, m) : mirror_projection(r, q, m))) return false;
        project(m, r.exits > 0, q);
        if (q.kind == SK_POLYGON) project_fan(m, sources_.fans, q);
        q.relay = uint32_t(out_.relays.size());
        q.power *= float(r.reflectance);

        apertures_.push_back(seen_apertures(apertures_[i], r, m));
        last_relay_.push_back(r.prim);
        const Apertures& apertures = apertures_.back();
        out_.relays.push_back({r.prim, i, exit, uint32_t(out_.apertures.size()), uint32_t(apertures.size())});
        append(out_.apertures, apertures);
        sources_.records.push_back(q);
        out_.shadows_need(SHADOW_AIMED);
        return true;
    }

private:
    FlatScene& out_;
    Sources& sources_;
    std::vector<uint32_t> last_relay_;  // by source, as apertures_
    std::vector<Apertures> apertures_;
};

}  // namespace

void add_virtual_sources(const std::vector<Relay>& relays, int levels, FlatScene& out, Sources& sources) {
    VirtualSources added(out, sources);
    uint32_t first = 0, end = sources.count();
    for (int level = 0; level < levels; level++) {
        for (uint32_t i = first; i < end; i++)
            for (const Relay& r : relays)
                for (uint32_t exit = 0; exit < uint32_t(std::max(1, r.exits)); exit++) {
                    if (!added.add(i, r, exit) || !added.full()) continue;
                    base::warn("", "more than 4096 virtual sources, the rest is left out (-dr)");
                    return;
                }
        first = end;
        end = sources.count();
    }
}

}  // namespace flatten
