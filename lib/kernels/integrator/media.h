// SPDX-License-Identifier: BSD-3-Clause
// The medium that the ray has crossed on its way here: what it swallows, what it adds.
#ifndef LUX_PATH_MEDIA_H
#define LUX_PATH_MEDIA_H

// Returns PATH_SHADOW if light scattered in the medium waits for its shadow ray.
FN int path_media(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                  PRIVATE(Vertex) vertex) {
    int result = 0;
    if (!vertex->absorbs) return 0;
    Medium crossed = vertex->arriving;
    if (vertex->g.mixed) crossed = path_medium(paths, vertex->path);
    if (!(max3(crossed.k) > 0.0f)) return 0;

    float3 T = attenuation(crossed.k, vertex->g.length);
    vertex->scatterers = scattered_count(s, par, &crossed);
    if (vertex->wanted) vertex_add(vertex, medium_glow(par, &crossed, T));

    if (vertex->wanted && vertex->scatterers > 0u) {
        // one shadow ray a step: if it goes to the mist, the surface's own direct light is left to other samples
        float2 x = sample2(&vertex->rnd), y = sample2(&vertex->rnd);
        vertex->went_to_medium = x.x >= 0.5f;
        if (vertex->went_to_medium) result = path_scatter(s, par, paths, &crossed, x, y, vertex);
    }

    vertex->throughput = mul3(vertex->throughput, T);
    return result;
}
#endif
