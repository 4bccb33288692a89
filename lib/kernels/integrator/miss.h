// SPDX-License-Identifier: BSD-3-Clause
// A ray without a hit: sun, sky and ground glow, through the remaining medium.
#ifndef LUX_PATH_MISS_H
#define LUX_PATH_MISS_H

FN void path_miss(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths,
                  PRIVATE(Vertex) vertex) {
    if (vertex->absorbs) {
        float3 T = attenuation(vertex->arriving.k, ENDLESS_MEDIUM);
        if (vertex->wanted) vertex_add(vertex, medium_glow(par, &vertex->arriving, T));
        vertex->throughput = mul3(vertex->throughput, T);
    }

    if (par->mode == MODE_IMAGE && (par->flags & PF_DIRECTIONS) != 0u) {
        if ((vertex->flags & PC_BENT) != 0u) vertex->rad = vertex->ray.dir;
        vertex_store_rad(paths, vertex, vertex->path_length_start);
        return;
    }

    // a ray that the view cuts off (-va) sees black, not the sky
    PRIVATE(const Ray) ray = &vertex->ray;
    if (IS_DISTANT(ray->tmax) && vertex->wanted && sees_hours_sky(s, par, ray->dir, vertex->flags)) {
        path_end_in_sky(paths, vertex);
    } else if ((vertex->wanted || par->mode == MODE_IMAGE) && IS_DISTANT(ray->tmax)) {
        float3 sky = path_background(s, par, vertex->path, ray->org, ray->dir, vertex->flags, &vertex->rnd);
        if ((vertex->flags & PC_RECORDS_SUFFIX) != 0u && (par->flags & PF_SKY_PLACES) == 0u)
            suffix_sky(paths, vertex, sky);
        else vertex_add(vertex, sky);
    }
    vertex_store_rad(paths, vertex, vertex->path_length_start);
}
#endif
