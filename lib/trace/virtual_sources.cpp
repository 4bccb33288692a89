// SPDX-License-Identifier: BSD-3-Clause
// Virtual sources: every active source mirrored in every flat mirror it faces, or bent by every prism, and those again,
// up to -dr levels (spec shading 3.18, 4.6).  A shadow ray aimed at one must meet the relay, then find the real source.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "trace/flatten.h"
#include "trace/host_tracer.h"

namespace trace {
namespace {
using namespace kernels;
using base::Vec3;

constexpr size_t MOST = 4096;

Vec3 get(const float* q) { return {q[0], q[1], q[2]}; }
void put(float* q, Vec3 v) {
    q[0] = float(v.x);
    q[1] = float(v.y);
    q[2] = float(v.z);
}
// Affine map that carries a source to its virtual place: p + (p.n - offset) h, then the mirror in the plane if asked.
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

// The gates of a source seen through one more relay: its own, then those behind it where a mirror shows them.  How a
// prism shows them is not known.
using Gates = std::vector<Flattener::Gate>;
Gates seen_gates(const Gates& behind, const Flattener::Relay& r, const Projection& m) {
    Gates gates{r.gate};
    if (r.exits) return gates;
    for (const Flattener::Gate& g : behind)
        gates.push_back({m.point(g.centre), m.vector(g.normal), m.vector(g.u), m.vector(g.v), g.both_sides});
    return gates;
}

// A prism shears what it shows: spheres and suns get axes that can be sheared (spec shading 4.3).
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

void append(std::vector<float>& out, const Gates& gates) {
    for (const Flattener::Gate& g : gates) {
        float f[GATE_FLOATS];
        put(f + GATE_CENTRE, g.centre);
        put(f + GATE_NORMAL, g.normal);
        put(f + GATE_U, g.u);
        put(f + GATE_V, g.v);
        f[GATE_BOTH_SIDES] = g.both_sides;
        out.insert(out.end(), f, f + GATE_FLOATS);
    }
}

bool mirror_projection(const Flattener::Relay& r, const float* q, Projection& m) {
    m = {r.normal, {}, dot(r.normal, r.centre), true};
    const Vec3 c = get(q + SRC_CENTRE);
    // the source, at least its extreme point, must stand before the mirror
    const double reach = bits(q[SRC_KIND]) == SK_CYLINDER ? q[SRC_RADIUS] + length(get(q + SRC_U)) : q[SRC_RADIUS];
    return bits(q[SRC_KIND]) == SK_DISTANT ? dot(c, m.n) + reach > 0 : dot(c, m.n) - m.offset + reach > 1e-6;
}

// A test ray from the source through the middle of the panel tells how the prism bends (spec shading 3.18).
bool prism_projection(const FlatScene& scene, const uint32_t* mod, const Flattener::Relay& r, uint32_t exit, Vec3 d0,
                      Projection& m) {
    const RayVars vars = ray_vars(scene, r.centre, d0, r.normal);
    float v[16];
    if (!run_program(scene, mod[MOD_PROGRAM], vars.values, v)) return false;
    const float* e = v + 4 * exit;
    Vec3 d1{e[1], e[2], e[3]};
    if (e[0] <= 1e-6f || length(d1) <= 1e-6) return false;
    d1 = unit(d1);
    const double a = dot(d0, r.normal), b = dot(d1, r.normal);
    if (std::fabs(a) <= 1e-6 || std::fabs(b) <= 1e-6) return false;
    m = {r.normal, d1 * (1 / b) - d0 * (1 / a), dot(r.normal, r.centre), (a > 0) != (b > 0)};
    return m.mirrored || length(m.h) > 1e-6;
}
}  // namespace

void Flattener::add_virtual_sources(std::vector<float>& records, std::vector<float>& fans,
                                    std::vector<std::pair<size_t, size_t>>& fan_patches) {
    size_t first = 0, end = records.size() / SOURCE_FLOATS;
    std::vector<uint32_t> last_relay(end, NONE);
    std::vector<Gates> gates(end);
    for (int level = 0; level < options.dr; level++) {
        for (size_t i = first; i < end; i++)
            for (const Relay& r : relays)
                for (uint32_t exit = 0; exit < uint32_t(std::max(1, r.exits)); exit++) {
                    if (last_relay[i] == r.prim) continue;
                    float q[SOURCE_FLOATS];
                    std::copy_n(&records[i * SOURCE_FLOATS], SOURCE_FLOATS, q);
                    const bool distant = bits(q[SRC_KIND]) == SK_DISTANT;
                    const Vec3 c = get(q + SRC_CENTRE);
                    Projection m;
                    if (r.exits ? !prism_projection(out, &mods[r.modifier * MOD_WORDS], r, exit,
                                                    distant ? -c : unit(r.centre - c), m)
                                : !mirror_projection(r, q, m))
                        continue;
                    const bool sphere = bits(q[SRC_KIND]) == SK_SPHERE;
                    if (r.exits && (distant || sphere)) give_axes(q, distant);
                    put(q + SRC_CENTRE, distant ? unit(m.vector(c)) : m.point(c));
                    const double scale = distant ? 1 / length(m.vector(c)) : 1;
                    for (uint32_t k : {SRC_U, SRC_V, SRC_NORMAL, SRC_SPOT}) put(q + k, m.vector(get(q + k)) * scale);
                    if (q[SRC_SPOT + 3] > -1.5f) put(q + SRC_SPOT, unit(get(q + SRC_SPOT)));
                    if (!sphere && !distant) put(q + SRC_NORMAL, unit(get(q + SRC_NORMAL)));
                    if (bits(q[SRC_KIND]) == SK_POLYGON) {
                        size_t at = 0;
                        for (const auto& p : fan_patches)
                            if (p.first == i * SOURCE_FLOATS) at = p.second;
                        const size_t count = bits(q[SRC_NTRIS]) * 12;
                        fan_patches.push_back({records.size(), fans.size()});
                        const std::vector<float> copy(fans.begin() + long(at), fans.begin() + long(at + count));
                        for (size_t t = 0; t < count; t += 12) {
                            float rec[12];
                            std::copy_n(&copy[t], 12, rec);
                            put(rec, m.point(get(rec)));
                            put(rec + 3, m.vector(get(rec + 3)));
                            put(rec + 6, m.vector(get(rec + 6)));
                            fans.insert(fans.end(), rec, rec + 12);
                        }
                    }
                    q[SRC_VIRTUAL] = from_bits(uint32_t(out.u.size()));
                    q[SRC_POWER] *= float(r.reflectance);
                    gates.push_back(seen_gates(gates[i], r, m));
                    out.u.insert(out.u.end(),
                                 {r.prim, uint32_t(i), exit, uint32_t(gates.back().size()), uint32_t(out.f.size())});
                    append(out.f, gates.back());
                    records.insert(records.end(), q, q + SOURCE_FLOATS);
                    last_relay.push_back(r.prim);
                    aimed = true;
                    if (last_relay.size() >= MOST) {
                        base::warn("", "more than 4096 virtual sources, the rest is left out (-dr)");
                        return;
                    }
                }
        first = end;
        end = last_relay.size();
    }
}

}  // namespace trace
