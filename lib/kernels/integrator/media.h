// SPDX-License-Identifier: BSD-3-Clause
// Absorption and emission of the medium that the ray has just crossed.
#ifndef LUX_PATH_MEDIA_H
#define LUX_PATH_MEDIA_H

// Returns PATH_SHADOW if in-scattered light waits for its shadow ray.
FN int path_media(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                  PRIVATE(Vertex) vertex) {
    int result = 0;
    if (!vertex->absorbs) return 0;
    Medium crossed = vertex->arriving;
    if (vertex->g.mixed) crossed = path_medium(paths, vertex->path);
    if (!(max3(crossed.k) > 0.0f)) return 0;

    float3 T = attenuation(crossed.k, vertex->g.length);
    vertex->scatterers = scattered_count(s, &crossed);
    if (vertex->wanted) vertex_add(vertex, medium_glow(par, &crossed, T));

    if (vertex->wanted && vertex->scatterers > 0u) {
        // one shadow ray a step: if the medium takes it, other samples estimate the surface's direct light
        float2 x = sample2(&vertex->rnd), y = sample2(&vertex->rnd);
        vertex->went_to_medium = x.x >= 0.5f;
        if (vertex->went_to_medium) result = path_scatter(s, par, paths, &crossed, x, y, vertex);
    }

    vertex->throughput = mul3(vertex->throughput, T);
    return result;
}
#endif
