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

void append(std::vector<float>& out, const Apertures& apertures) {
    for (const Aperture& g : apertures) {
        float f[APERTURE_FLOATS];
        put(f + APERTURE_CENTRE, g.centre);
        put(f + APERTURE_NORMAL, g.normal);
        put(f + APERTURE_U, g.u);
        put(f + APERTURE_V, g.v);
        f[APERTURE_BOTH_SIDES] = g.both_sides;
        out.insert(out.end(), f, f + APERTURE_FLOATS);
    }
}

// A prism shears the image: spheres and suns get axes that can be sheared (spec shading 4.3).
void give_axes(float* q, bool distant) {
    if (q[SRC_SHEARED] != 0) return;
    q[SRC_SHEARED] = 1;
    const Vec3 c = get(q + SRC_CENTRE);
    const double half = distant ? std::sqrt(q[SRC_AREA]) / 2 : .7236 * q[SRC_RADIUS];
    const Vec3 u = distant ? unit(cross(c, std::fabs(c.z) < .9 ? Vec3{0, 0, 1} : Vec3{1, 0, 0})) : Vec3{1, 0, 0};
    const Vec3 v = distant ? cross(c, u) : Vec3{0, 1, 0};
    put(q + SRC_U, u * half);
    put(q + SRC_V, v * half);
    put(q + SRC_NORMAL, distant ? Vec3() : Vec3{0, 0, half});
}

bool mirror_projection(const Relay& r, const float* q, Projection& m) {
    m = {r.normal, {}, dot(r.normal, r.centre), true};
    const Vec3 c = get(q + SRC_CENTRE);
    // the source, at least its extreme point, must be in front of the mirror
    const double reach = bits(q[SRC_KIND]) == SK_CYLINDER ? q[SRC_RADIUS] + length(get(q + SRC_U)) : q[SRC_RADIUS];
    return bits(q[SRC_KIND]) == SK_DISTANT ? dot(c, m.n) + reach > 0 : dot(c, m.n) - m.offset + reach > 1e-6;
}

// A test ray from the source through the middle of the panel gives the prism's deflection (spec shading 3.18).
bool prism_projection(const FlatScene& scene, const Relay& r, uint32_t exit, const float* q, Projection& m) {
    const bool distant = bits(q[SRC_KIND]) == SK_DISTANT;
    const Vec3 c = get(q + SRC_CENTRE), d0 = distant ? -c : unit(r.centre - c);
    const RayVars vars = ray_vars(scene, r.centre, d0, r.normal);
    float v[16];
    if (!run_program(scene, scene.record(r.material)[MOD_PROGRAM], vars.values, v)) return false;
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
void project(const Projection& m, bool by_prism, float* q) {
    const bool distant = bits(q[SRC_KIND]) == SK_DISTANT, sphere = bits(q[SRC_KIND]) == SK_SPHERE;
    const Vec3 c = get(q + SRC_CENTRE);
    if (by_prism && (distant || sphere)) give_axes(q, distant);
    put(q + SRC_CENTRE, distant ? unit(m.vector(c)) : m.point(c));
    const double scale = distant ? 1 / length(m.vector(c)) : 1;
    for (uint32_t k : {SRC_U, SRC_V, SRC_NORMAL, SRC_SPOT}) put(q + k, m.vector(get(q + k)) * scale);
    if (IS_SPOT(q)) put(q + SRC_SPOT, unit(get(q + SRC_SPOT)));
    if (!sphere && !distant) put(q + SRC_NORMAL, unit(get(q + SRC_NORMAL)));
}

// Copies the triangles of general polygon i to the next source.
void project_fan(const Projection& m, size_t i, Sources& sources) {
    size_t at = 0;
    for (const Sources::Fan& fan : sources.fan_of)
        if (fan.source == i) at = fan.at;
    const size_t end = at + bits(sources.record(i)[SRC_NTRIS]) * FAN_FLOATS;
    sources.fan_of.push_back({sources.count(), sources.fans.size()});
    for (; at < end; at += FAN_FLOATS) {
        float f[FAN_FLOATS];
        std::copy_n(&sources.fans[at], FAN_FLOATS, f);
        put(f, m.point(get(f)));
        put(f + 3, m.vector(get(f + 3)));
        put(f + 6, m.vector(get(f + 6)));
        sources.fans.insert(sources.fans.end(), f, f + FAN_FLOATS);
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
        float q[SOURCE_FLOATS];
        std::copy_n(sources_.record(i), SOURCE_FLOATS, q);
        Projection m;
        if (!(r.exits ? prism_projection(out_, r, exit, q, m) : mirror_projection(r, q, m))) return false;
        project(m, r.exits > 0, q);
        if (bits(q[SRC_KIND]) == SK_POLYGON) project_fan(m, i, sources_);
        q[SRC_VIRTUAL] = from_bits(uint32_t(out_.u.size()));
        q[SRC_POWER] *= float(r.reflectance);

        apertures_.push_back(seen_apertures(apertures_[i], r, m));
        last_relay_.push_back(r.prim);
        const Apertures& apertures = apertures_.back();
        out_.u.insert(out_.u.end(), {r.prim, i, exit, uint32_t(apertures.size()), uint32_t(out_.f.size())});
        append(out_.f, apertures);
        sources_.records.insert(sources_.records.end(), q, q + SOURCE_FLOATS);
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
