// SPDX-License-Identifier: BSD-3-Clause
// Small sources, splatted into frame 0 by area.
#ifndef LUX_PATH_SPLAT_H
#define LUX_PATH_SPLAT_H

// MODE_SPLAT: the shadow ray of path i is a straight ray from the eye to a point of a source, with its weight, written
// by the host; the source's radiance is applied here, path_shadow follows.
FN void path_splat(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    Row_shadow_org from = shadow_org_of(paths->shadow_org[path]);
    Row_shadow_dir to = shadow_dir_of(paths->shadow_dir[path]);
    GLOBAL const Source* src = source_record(s, from.source);
    float3 org = from.point, dir = to.way;
    float dist = to.distance;
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, path + par->first, 0u, 3u);
    float3 normal = neg3(dir), point = org;

    if (src->kind != SK_DISTANT) {
        point = madd3(dir, dist, org);
        normal = src->kind == SK_SPHERE ? unit3(sub3(point, f3_of(src->centre))) : f3_of(src->normal);
    }

    if (!IS_DISTANT(dist)) {
        float3 way = way_before_source(s, src, org, scale3(dir, dist));
        paths->shadow_dir[path] = shadow_dir_words(unit3(way), length3(way));
    }

    float3 e = F3(1.0f, 1.0f, 1.0f);
    if (src->mod != NONE) e = light_radiance(s, par, src->mod, src->prim, dir, point, normal, dist, dist, &rnd);
    paths->shadow_rad[path] = shadow_rad_words(mul3(xyz4(paths->shadow_rad[path]), e), 0.0f);
    paths->rad[path] = rad_words(F3(0.0f, 0.0f, 0.0f), 0.0f);

    if (path_media_used(par)) {
        Medium open = medium_open(par);
        open.albedo = F3(0.0f, 0.0f, 0.0f);  // what the eye sees is dimmed by all extinction
        set_shadow_medium(paths, path, &open, CLIP_START);
    }

    rnd.dim = 0u;
    paths->info[path] = info_words(0u, &rnd, NONE);
}
#endif
