// SPDX-License-Identifier: BSD-3-Clause
// Small sources, splatted into frame 0 by area.
#ifndef LUX_PATH_SPLAT_H
#define LUX_PATH_SPLAT_H

// MODE_SPLAT: the shadow ray of path i is a straight ray from the eye to a point of a source, with its weight, written
// by the host; the source's radiance is applied here, path_shadow follows.
FN void path_splat(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    uint source = as_uint_(paths->shadow_org[path].w);
    GLOBAL const float* src = source_record(s, par, source);
    float3 org = xyz4(paths->shadow_org[path]), dir = xyz4(paths->shadow_dir[path]);
    float dist = paths->shadow_dir[path].w;
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, path + par->first, 0u, 3u);
    float3 normal = neg3(dir), point = org;

    if (as_uint_(src[SRC_KIND]) != SK_DISTANT) {
        point = madd3(dir, dist, org);
        normal = as_uint_(src[SRC_KIND]) == SK_SPHERE ? unit3(sub3(point, f3_at(src + SRC_CENTRE)))
                                                      : f3_at(src + SRC_NORMAL);
    }

    if (!IS_DISTANT(dist)) {
        float3 way = way_before_source(s, src, org, scale3(dir, dist));
        paths->shadow_dir[path] = pack4(unit3(way), length3(way));
    }

    float3 e =
        light_radiance(s, par, as_uint_(src[SRC_MOD]), as_uint_(src[SRC_PRIM]), dir, point, normal, dist, dist, &rnd);
    paths->shadow_rad[path] = pack4(mul3(xyz4(paths->shadow_rad[path]), e), 0.0f);
    paths->rad[path] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);

    if (path_media_used(par)) {
        Medium open = medium_open(par);
        open.albedo = F3(0.0f, 0.0f, 0.0f);  // what the eye sees is dimmed by all extinction
        set_shadow_medium(paths, path, &open, CLIP_START);
    }

    uint4 info;
    info.x = 0u;
    info.y = rnd.key;
    info.z = rnd.index;
    info.w = NONE;
    paths->info[path] = info;
}
#endif
