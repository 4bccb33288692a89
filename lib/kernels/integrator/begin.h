// SPDX-License-Identifier: BSD-3-Clause
// Starts paths: the ray of a pixel's sample, or the given ray of MODE_RAY, traced to its first hit.
#ifndef LUX_PATH_BEGIN_H
#define LUX_PATH_BEGIN_H

// Focus entry of a path's pixel, in a pass over pixels with several samples in each frame.
FN GLOBAL const FocusEntry* focus_entry(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path) {
    return &s->focus[par->focus_at + quotient_(par->first + path, par->samples_per_pass)];
}

// Pixel of a path, NONE outside the picture, and the number of the pixel's sample.
FN uint path_pixel(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path) {
    if (par->mode == MODE_RAY) return 0u;
    if (par->reuse_path_count != 0u) return reuse_pixel(par, par->first + path);
    if (par->spp > 1u) {
        GLOBAL const FocusEntry* entry = focus_entry(s, par, path);
        return entry->pixel;
    }
    return quotient_(par->first + path, par->samples_per_pass);
}

FN uint path_sample_index(PARAMS(const Params) par, uint path) {
    uint gid = par->first + path;
    if (par->reuse_path_count != 0u) return par->frame + quotient_(gid, par->reuse_path_count);
    if (par->mode == MODE_RAY) return par->frame + gid;
    uint in_pass = gid - quotient_(gid, par->samples_per_pass) * par->samples_per_pass;
    return par->frame + quotient_(in_pass, par->spp);
}

// Ray through a random point of the pixel and of the lens.  Returns 0 if the view has no ray there.
FN int camera_ray(PARAMS(const Params) par, uint pixel, PRIVATE(Sampler) rnd, PRIVATE(Ray) ray) {
    float2 r = sample2(rnd);
    float jitter = par->pixel_jitter;
    uint row = quotient_(pixel, par->nx);
    float x = (float)(pixel - row * par->nx) + 0.5f + jitter * (0.5f - r.x);
    float y = (float)(par->ny - 1u - row) + 0.5f + jitter * (0.5f - r.y);

    float3 lens = F3(0.0f, 0.0f, 0.0f);
    if (par->lens_diameter > 0.0f) {
        r = sample2(rnd);
        lens = F3(r.x, r.y, sample1(rnd));
    }

    return view_lens_ray(par, x / (float)par->nx, y / (float)par->ny, lens, ray);
}

// Ray of a point of -points.  Returns 0 for pixels without one.
FN int point_ray(TABLES(const SceneTables) s, uint point, PRIVATE(Ray) ray) {
    ray->org = f3_of(s->points[point].org);
    ray->dir = f3_of(s->points[point].dir);
    ray->tmax = FAR_AWAY;
    return dot3(ray->dir, ray->dir) > 0.0f;
}

// The point whose pixel is at this place of the picture, 0 .. 1.
FN uint point_at(PARAMS(const Params) par, float x, float y) {
    return (uint)(y * (float)par->ny) * par->nx + (uint)(x * (float)par->nx);
}

FN void given_ray(PARAMS(const Params) par, PRIVATE(Sampler) rnd, PRIVATE(Ray) ray) {
    ray->org = f3_of(par->ray_org);
    ray->dir = f3_of(par->ray_dir);
    ray->tmax = FAR_AWAY;
    rnd->dim = 1u;
}

// Initial state of every path, except the direction of its first ray.
FN void path_start(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, float3 org,
                   PRIVATE(const Sampler) rnd, uint flags) {
    write4_(paths->org, path, org_words(org, CLIP_START));
    write4_(paths->throughput, path, throughput_words(F3(1.0f, 1.0f, 1.0f), 1.0f));
    if (has_media(par)) {
        Medium open = medium_open(par);
        set_path_medium(paths, path, &open);
    }
    write4_(paths->info, path, info_words(flags, rnd, NONE));
}

// A path of path reuse has no prefix or suffix vertex yet (suffix.h).
FN void no_ends(TABLES(const Paths) paths, uint path) {
    write4_(paths->prefix_n, path, prefix_n_words(F3(0.0f, 0.0f, 0.0f), NO_PREFIX));
    write4_(paths->suffix_p, path, suffix_p_words(F3(0.0f, 0.0f, 0.0f), SUFFIX_NONE));
}

// The first ray of a path, and its random numbers.  Returns 0 if there is none.
FN int path_first_ray(TABLES(const SceneTables) s, PARAMS(const Params) par, uint path, PRIVATE(Sampler) rnd,
                      PRIVATE(Ray) ray) {
    uint pixel = path_pixel(s, par, path), index = path_sample_index(par, path);
    if (pixel == NONE) return 0;

    // Frame 0's direct samples 0 .. m-1 and the sample k-1 of each later frame k are one sequence, so that the direct
    // class of L'(n) is the mean of its first n samples: full nets at 64, 128, ...
    if (par->mode == MODE_FRAMES) index--;
    uint stream = par->mode == MODE_RAY ? 2u : 0u;

    // The samples of a pixel in one frame are a sequence of their own in each block of frames, so that blocks stay
    // independent.
    if (par->spp > 1u) {
        GLOBAL const FocusEntry* entry = focus_entry(s, par, path);
        uint gid = par->first + path;
        uint copy = entry->from + (gid - quotient_(gid, par->spp) * par->spp);
        stream = 4u + (index >> SAMPLER_BLOCK_BITS);
        index = (index & ((1u << SAMPLER_BLOCK_BITS) - 1u)) * entry->spp + copy;
    }
    *rnd = sampler_start(par->seed_lo, par->seed_hi, pixel, index, stream);

    int has_ray = 1;
    if (par->mode == MODE_RAY) given_ray(par, rnd, ray);
    else if (par->points_count > 0u) has_ray = point_ray(s, pixel, ray);
    else has_ray = camera_ray(par, pixel, rnd, ray);
    if (par->redraw != 0u) rnd->key = hash32(rnd->key ^ par->redraw);
    return has_ray;
}

// Returns 1 if the path has a ray to follow.
FN int path_generate(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    Sampler rnd;
    Ray ray;
    write4_(paths->rad, path, rad_words(F3(0.0f, 0.0f, 0.0f), 0.0f));
    if (par->reuse_path_count != 0u) no_ends(paths, path);
    if ((par->flags & PF_HOURS) != 0u) write4_(paths->sky_way, path, sky_way_words(F3(0.0f, 0.0f, 0.0f), SKY_NONE));
    if (!path_first_ray(s, par, path, &rnd, &ray)) return 0;

    write4_(paths->dir, path, dir_words(ray.dir, ray.tmax));
    path_start(par, paths, path, ray.org, &rnd, 0u);
    return 1;
}

FN Ray path_ray(TABLES(const Paths) paths, uint path) {
    Ray ray;
    Row_dir dir = dir_of(paths->dir[path]);
    ray.org = xyz4(paths->org[path]);
    ray.dir = dir.way;
    ray.tmin = 0.0f;
    ray.tmax = dir.length;
    return ray;
}

FN Hit hit_at_once(uint prim) {
    Hit hit;
    hit.t = hit.u = hit.v = 0.0f;
    hit.prim = prim;
    hit.inst = NO_HIT;
    return hit;
}

// Traces the ray of a path to the nearest surface, except a surface on which the eye lies.
FN void path_extend(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    Ray ray = path_ray(paths, path);
    Hit hit;
    uint flags = info_flags(paths->info[path]);
    if (begins_on_sensor(par, flags)) {
        hit = hit_at_once(ON_SENSOR);
        set_path_hit(paths, path, &hit);
        return;
    }
    int from_surface = (par->flags & PF_EYE_ON_SURFACE) != 0u && path_steps(flags) == 0u;
    for (;;) {
        trace_closest(s, &ray, RAY_ALL, &hit);
        if (!from_surface || !holds_origin(s, &ray, &hit)) break;
        ray.tmin = hit.t;
    }
    set_path_hit(paths, path, &hit);
}
#endif
