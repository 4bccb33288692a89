// SPDX-License-Identifier: BSD-3-Clause
// Virtual sources: every active source mirrored in every flat mirror it faces, and those again, up to -dr levels
// (spec shading 4.6).  A shadow ray aimed at one must meet the mirror and then find the real source.
#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "trace/flatten.h"

namespace trace {
namespace {
using namespace kernels;
using base::Vec3;

constexpr size_t MOST = 4096;

Vec3 get(const float* q) { return {q[0], q[1], q[2]}; }
void put(float* q, Vec3 v) { q[0] = float(v.x); q[1] = float(v.y); q[2] = float(v.z); }
}  // namespace

void Flattener::add_virtual_sources(std::vector<float>& records, std::vector<float>& fans,
                                    std::vector<std::pair<size_t, size_t>>& fan_patches) {
    size_t first = 0, end = records.size() / SOURCE_FLOATS;
    std::vector<uint32_t> last_relay(end, NONE);
    for (int level = 0; level < options.dr; level++) {
        for (size_t i = first; i < end; i++) {
            for (const Relay& r : relays) {
                if (last_relay[i] == r.prim) continue;
                float q[SOURCE_FLOATS];
                std::copy_n(&records[i * SOURCE_FLOATS], SOURCE_FLOATS, q);
                const Vec3 n = r.normal, c = get(q + SRC_CENTRE);
                const double offset = dot(n, r.centre);
                const auto mirror_v = [&](Vec3 v) { return v - n * (2 * dot(v, n)); };
                const auto mirror_p = [&](Vec3 p) { return p - n * (2 * (dot(p, n) - offset)); };
                const bool distant = bits(q[SRC_KIND]) == SK_DISTANT;
                // the source, at least its extreme point, must stand before the mirror
                const double reach = bits(q[SRC_KIND]) == SK_CYLINDER ? q[SRC_RADIUS] + length(get(q + SRC_U)) : q[SRC_RADIUS];
                if (distant ? dot(c, n) + reach <= 0 : dot(c, n) - offset + reach <= 1e-6) continue;
                put(q + SRC_CENTRE, distant ? mirror_v(c) : mirror_p(c));
                for (uint32_t k : {SRC_U, SRC_V, SRC_NORMAL, SRC_SPOT}) put(q + k, mirror_v(get(q + k)));
                if (bits(q[SRC_KIND]) == SK_POLYGON) {
                    size_t at = 0;
                    for (const auto& p : fan_patches) if (p.first == i * SOURCE_FLOATS) at = p.second;
                    const size_t count = bits(q[SRC_NTRIS]) * 12;
                    fan_patches.push_back({records.size(), fans.size()});
                    const std::vector<float> copy(fans.begin() + long(at), fans.begin() + long(at + count));
                    for (size_t t = 0; t < count; t += 12) {
                        float rec[12];
                        std::copy_n(&copy[t], 12, rec);
                        put(rec, mirror_p(get(rec)));
                        put(rec + 3, mirror_v(get(rec + 3)));
                        put(rec + 6, mirror_v(get(rec + 6)));
                        fans.insert(fans.end(), rec, rec + 12);
                    }
                }
                q[SRC_VIRTUAL] = from_bits(uint32_t(out.u.size()));
                out.u.insert(out.u.end(), {r.prim, uint32_t(i), bits(float(r.centre.x)), bits(float(r.centre.y)),
                                           bits(float(r.centre.z)), bits(float(r.radius))});
                records.insert(records.end(), q, q + SOURCE_FLOATS);
                last_relay.push_back(r.prim);
                aimed = true;
                if (last_relay.size() >= MOST) {
                    base::warn("", "more than 4096 virtual sources, the rest is left out (-dr)");
                    return;
                }
            }
        }
        first = end;
        end = last_relay.size();
    }
}

}  // namespace trace
