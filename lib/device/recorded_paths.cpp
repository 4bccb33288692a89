// SPDX-License-Identifier: BSD-3-Clause
// See recorded_paths.h.
#include "device/recorded_paths.h"

#include "device/scene_tables.h"

namespace kernels {
struct Paths;
struct Vertex;
struct LobeSample;
static inline void record_vertex(const Paths* paths, const Vertex* vertex, int kind, const LobeSample* lobe);
}  // namespace kernels
#define RECORD_VERTEX(paths, vertex, kind, lobe) record_vertex(paths, vertex, kind, lobe)
#define LUX_ISA recorded
#include "device/cpu_kernels.inl"

namespace kernels {
static device::Rgb rgb_of(float3 v) { return {double(v.x), double(v.y), double(v.z)}; }

// Paths whose vertices are recorded.
struct PathsToRecord : Paths {
    std::vector<device::RecordedPath>* out;
    const Params* par;
    device::RecordedVertex& last(uint32_t path) const { return (*out)[path].back(); }
    void add(uint32_t path, device::RecordedLight::From from, uint32_t which, bool shared, float3 now,
             float3 before) const {
        device::RecordedLight light{from, which, shared, rgb_of(now)};
        const device::Rgb less = rgb_of(before);
        for (size_t c = 0; c < 3; c++) light.rgb[c] -= less[c];
        if (light.rgb != device::Rgb{}) last(path).lights.push_back(light);
    }
    // Radiance that the path has for itself, and for its suffix vertex.
    float3 own(uint32_t path) const { return xyz4(rad[path]); }
    float3 shared(uint32_t path) const {
        if (par->reuse_path_count == 0 || suffix_p_kind(suffix_p[path]) == SUFFIX_NONE) return F3(0.0f, 0.0f, 0.0f);
        return xyz4(suffix_rad[path]);
    }
};

static const char* lobe_name(uint lobe) {
    switch (lobe) {
    case SAMPLE_DIFFUSE_R: return "diffuse";
    case SAMPLE_DIFFUSE_T: return "diffuse through";
    case SAMPLE_ROUGH_R: return "rough";
    case SAMPLE_ROUGH_T: return "rough through";
    case SAMPLE_THROUGH: return "through";
    case SAMPLE_MIRROR: return "mirror";
    default: return "refracted";
    }
}

// Called by path_shade() when the vertex is known, and again with its lobe.
static inline void record_vertex(const Paths* paths, const Vertex* vertex, int kind, const LobeSample* lobe) {
    const auto& to = static_cast<const PathsToRecord&>(*paths);
    device::RecordedVertex& v = to.last(vertex->path);
    if (lobe) return void(v.lobe = lobe_name(lobe->type));
    if (kind == HIT_NULL) v.lobe = "passes";
    v.is_emitter = kind == HIT_EMITTER;
    v.modifier = vertex->g.mod;
    const float3 centre = f3_of(to.par->centre);
    for (size_t c = 0; c < 3; c++) v.point[c] = rgb_of(vertex->g.p)[c] + rgb_of(centre)[c];
    const bool behind = (info_flags(to.info[vertex->path]) & PC_SUFFIX) != 0u;
    to.add(vertex->path, device::RecordedLight::From::medium, NONE, behind, vertex->rad,
           behind ? to.shared(vertex->path) : to.own(vertex->path));
}
}  // namespace kernels

namespace recorded {
using From = device::RecordedLight::From;

struct RecordingTile : Tile {
    PathsToRecord recorded;
};

// As OneByOne, with a record of each step.
struct Recording : OneByOne {
    static void shade(Tile& t) {
        const PathsToRecord& paths = static_cast<RecordingTile&>(t).recorded;
        for (uint32_t i = 0; i < t.n; i++) t.result[i] = shade_one(t, paths, t.now[i]);
    }
    static void shadow(Tile& t) {
        const PathsToRecord& paths = static_cast<RecordingTile&>(t).recorded;
        for (uint32_t i = 0; i < t.shadows; i++) {
            const uint32_t path = t.shadow[i], source = shadow_org_source(paths.shadow_org[path]);
            const float3 own = paths.own(path), shared = paths.shared(path);
            path_shadow(t.s, &t.par, &paths, path, t.result[i]);
            paths.add(path, From::source, source, false, paths.own(path), own);
            paths.add(path, From::source, source, true, paths.shared(path), shared);
        }
    }

private:
    static bool has_suffix(const Tile& t, const Paths& paths, uint32_t path) {
        return t.par.reuse_path_count != 0u && suffix_p_kind(paths.suffix_p[path]) != SUFFIX_NONE;
    }
    static int shade_one(Tile& t, const PathsToRecord& paths, uint32_t path) {
        Vertex before;
        vertex_load(&t.par, &paths, path, &before);
        device::RecordedVertex v{};
        v.prim = before.hit.prim;
        v.inst = before.hit.inst;
        v.modifier = NONE;
        v.lobe = "";
        v.bounces = path_bounces(before.flags);
        v.throughput = rgb_of(before.throughput);
        (*paths.out)[path].push_back(v);

        const bool had_suffix = has_suffix(t, paths, path), behind = (before.flags & PC_SUFFIX) != 0u;
        (*paths.out)[path].back().behind_suffix = behind;
        const float3 own = paths.own(path), shared = paths.shared(path);
        const int result = path_shade(t.s, &t.par, &paths, path);
        device::RecordedVertex& to = paths.last(path);
        From from = to.is_emitter ? From::surface : From::ambient;
        uint32_t which = NONE;
        float3 gained = F3(0.0f, 0.0f, 0.0f);  // already recorded: light of the medium
        if (v.prim == NO_HIT) {
            from = From::distant;
            which = distant_at(t.s, &t.par, before.ray.dir, path_sampled(before.flags));
            if (before.absorbs && before.wanted) gained = endless_glow(t, before);
            paths.add(path, From::medium, NONE, behind, gained, F3(0.0f, 0.0f, 0.0f));
        } else {
            for (const device::RecordedLight& l : to.lights)
                gained = F3(float(l.rgb[0]), float(l.rgb[1]), float(l.rgb[2]));
        }
        paths.add(path, from, which, false, paths.own(path), behind ? own : add3(own, gained));
        paths.add(path, from, which, true, paths.shared(path), behind ? add3(shared, gained) : shared);
        to.at_suffix = !had_suffix && has_suffix(t, paths, path);
        return result;
    }
    // Light of the medium that reaches from the last surface to where no surface is, as path_miss() adds it.
    static float3 endless_glow(const Tile& t, const Vertex& v) {
        const float3 T = attenuation(v.arriving.k, ENDLESS_MEDIUM);
        return mul3(v.throughput, medium_glow(&t.par, &v.arriving, T));
    }
};
}  // namespace recorded

namespace device {
using namespace kernels;

static std::vector<Connection> connections_of(const Paths* paths, uint32_t path) {
    std::vector<Connection> out;
    if (prefix_n_own(paths->prefix_n[path]) == NO_PREFIX) return out;
    const Rgb throughput = rgb_of(xyz4(paths->prefix_throughput[path]));
    for (uint32_t m = 0; m < REUSE_GROUP; m++) {
        const uint32_t suffix = reuse_member(path, m);
        if (!CONNECTS_SUFFIX(paths, suffix)) continue;
        Connection c{suffix, rgb_of(connection_weight(paths, suffix, m, reuse_which(path)))};
        for (size_t k = 0; k < 3; k++) c.weight[k] *= throughput[k] * double(suffix_mis_weight(paths, suffix));
        if (c.weight != Rgb{}) out.push_back(c);
    }
    return out;
}

RecordedPaths record_paths(const flatten::FlatScene& scene, const Params& par, uint32_t which) {
    const SceneTables tables = tables_of(scene, par);
    RecordedPaths out;
    out.paths.resize(par.path_count);
    std::vector<char> scratch(recorded::scratch_bytes(par.path_count));
    recorded::RecordingTile t{recorded::carve(tables, par, par.first, par.path_count, scratch.data()), {}};
    static_cast<Paths&>(t.recorded) = t.paths;
    t.recorded.out = &out.paths;
    t.recorded.par = &t.par;
    recorded::TileBackend<recorded::Recording> backend{t};
    run_paths(backend, par.reuse_path_count != 0);
    if (par.reuse_path_count != 0) out.connections = connections_of(&t.paths, which);
    return out;
}

}  // namespace device
