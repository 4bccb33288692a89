// SPDX-License-Identifier: BSD-3-Clause
// A path begins: the ray of a pixel's sample, or the one ray of MODE_RAY; and what a ray meets first.
#ifndef LUX_PATH_BEGIN_H
#define LUX_PATH_BEGIN_H

// The entry of a slot's pixel, in a pass of pixels with several samples in each frame.
FN GLOBAL const uint* focus_entry(TABLES(const SceneTables) s, PARAMS(const Params) par, uint slot) {
    return s->focus + FOCUS_WORDS * (par->focus_at + (par->first + slot) / par->together);
}

// The pixel of a slot, NONE if it lies beside the picture, and which of its samples the slot is.
FN uint path_pixel(TABLES(const SceneTables) s, PARAMS(const Params) par, uint slot) {
    if (par->mode == MODE_RAY) return 0u;
    if (par->reuse_slot_count != 0u) return reuse_pixel(par, par->first + slot);
    if (par->copies > 1u) return *(focus_entry(s, par, slot) + FOCUS_PIXEL);
    return (par->first + slot) / par->together;
}

FN uint path_sample_index(PARAMS(const Params) par, uint slot) {
    uint gid = par->first + slot;
    if (par->reuse_slot_count != 0u) return par->frame + gid / par->reuse_slot_count;
    return par->frame + (par->mode == MODE_RAY ? gid : gid % par->together / par->copies);
}

// The ray through a random place of the pixel and of the lens.  0 if the view has none there.
FN int camera_ray(PARAMS(const Params) par, uint pixel, PRIVATE(Sampler) rnd, PRIVATE(Ray) ray) {
    float2 r = sample2(rnd);
    float jitter = par->view_clip.z;  // -pj
    float x = (float)(pixel % par->nx) + 0.5f + jitter * (0.5f - r.x);
    float y = (float)(par->ny - 1u - pixel / par->nx) + 0.5f + jitter * (0.5f - r.y);

    float3 lens = F3(0.0f, 0.0f, 0.0f);
    if (par->view_clip.w > 0.0f) {
        r = sample2(rnd);
        lens = F3(r.x, r.y, sample1(rnd));
    }

    return view_lens_ray(par, x / (float)par->nx, y / (float)par->ny, lens, ray);
}

FN void given_ray(PARAMS(const Params) par, PRIVATE(Sampler) rnd, PRIVATE(Ray) ray) {
    ray->org = F3(par->ray_org.x, par->ray_org.y, par->ray_org.z);
    ray->dir = F3(par->ray_dir.x, par->ray_dir.y, par->ray_dir.z);
    ray->tmax = FAR_AWAY;
    rnd->dim = 1u;
}

// What every path begins with, beside the direction of its first ray.
FN void path_start(PARAMS(const Params) par, TABLES(const Paths) paths, uint slot, float3 org,
                   PRIVATE(const Sampler) rnd, uint flags) {
    write4_(paths->org, slot, pack4(org, as_float_(CLIP_START)));
    write4_(paths->thr, slot, pack4(F3(1.0f, 1.0f, 1.0f), 1.0f));
    if (has_media(par)) {
        Medium open = medium_open(par);
        set_path_medium(paths, slot, &open);
    }

    uint4 info;
    info.x = flags;
    info.y = rnd->key;
    info.z = path_sampler_word(rnd);
    info.w = NONE;
    write4_(paths->info, slot, info);
}

// A path that shares has no ends yet (suffix.h).
FN void no_ends(TABLES(const Paths) paths, uint slot) {
    write4_(paths->prefix_n, slot, pack4(F3(0.0f, 0.0f, 0.0f), NO_PREFIX));
    write4_(paths->suffix_p, slot, pack4(F3(0.0f, 0.0f, 0.0f), SUFFIX_NONE));
}

// 1 if the slot has a ray to follow.
FN int path_generate(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint slot) {
    uint pixel = path_pixel(s, par, slot), index = path_sample_index(par, slot);
    write4_(paths->rad, slot, pack4(F3(0.0f, 0.0f, 0.0f), 0.0f));
    if (par->reuse_slot_count != 0u) no_ends(paths, slot);
    if (pixel == NONE) return 0;

    // Frame 0's direct samples 0 .. m-1 and the sample k-1 of each later frame k are one sequence, so that the direct
    // class of L'(n) is the mean of its first n samples: full nets at 64, 128, ...
    if (par->mode == MODE_FRAMES) index--;
    uint stream = par->mode == MODE_RAY ? 2u : 0u;

    // Copies are a sequence as well, of its own in each block of frames: blocks stay independent of one another.
    if (par->copies > 1u) {
        GLOBAL const uint* entry = focus_entry(s, par, slot);
        uint copy = entry[FOCUS_FROM] + (par->first + slot) % par->copies;
        stream = 4u + (index >> SAMPLER_BLOCK_BITS);
        index = (index & ((1u << SAMPLER_BLOCK_BITS) - 1u)) * entry[FOCUS_ALL] + copy;
    }
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, pixel, index, stream);

    Ray ray;
    int has_ray = 1;
    if (par->mode == MODE_RAY) given_ray(par, &rnd, &ray);
    else has_ray = camera_ray(par, pixel, &rnd, &ray);
    if (par->redraw != 0u) rnd.key = hash32(rnd.key ^ par->redraw);

    if (!has_ray) return 0;

    write4_(paths->dir, slot, pack4(ray.dir, ray.tmax));
    path_start(par, paths, slot, ray.org, &rnd, 0u);
    return 1;
}

FN Ray path_ray(TABLES(const Paths) paths, uint slot) {
    Ray ray;
    float4 dir = paths->dir[slot];
    ray.org = xyz4(paths->org[slot]);
    ray.dir = xyz4(dir);
    ray.tmin = 0.0f;
    ray.tmax = dir.w;
    return ray;
}

// Follows the ray of a slot to the nearest surface; past one that the eye lies on.
FN void path_extend(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint slot) {
    Ray ray = path_ray(paths, slot);
    Hit hit;
    int from_surface = (par->flags & PF_EYE_ON_SURFACE) != 0u && paths->info[slot].x >> PC_STEP_SHIFT == 0u;
    for (;;) {
        trace_closest(s, &ray, RAY_ALL, &hit);
        if (!from_surface || !holds_origin(s, &ray, &hit)) break;
        ray.tmin = hit.t;
    }
    set_path_hit(paths, slot, &hit);
}
#endif
