// SPDX-License-Identifier: BSD-3-Clause
// One path per slot, in stages that run over queues (wavefront, Laine et al. 2013): generate, extend, shade; shadow.h
// has the last.  Frame 0 keeps the direct class, frames k >= 1 the diffuse one and, past the first m, both (paper
// section 7).
#ifndef LUX_PATH_H
#define LUX_PATH_H

// 1 if the slot has a ray to follow.
FN int path_generate(PRIVATE const Params* par, PRIVATE const Paths* a, uint slot) {
    uint pixels = par->nx * par->ny, gid = par->first + slot;
    uint pixel = par->mode == MODE_RAY ? 0u : gid % pixels;
    uint index = par->frame + (par->mode == MODE_RAY ? gid : gid / pixels);
    // Frame 0's direct samples 0 .. m-1 and the sample k-1 of each later frame k are one sequence, so that the direct
    // class of L'(n) is the mean of its first n samples: full nets at 64, 128, ...
    if (par->mode == MODE_FRAMES) index--;
    uint stream = par->mode == MODE_RAY ? 2u : 0u;
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, pixel, index, stream);
    Ray ray;
    int ok = 1;
    if (par->mode == MODE_RAY) {
        ray.org = F3(par->ray_org.x, par->ray_org.y, par->ray_org.z);
        ray.dir = F3(par->ray_dir.x, par->ray_dir.y, par->ray_dir.z);
        ray.tmax = 1e30f;
        rnd.dim = 1u;
    } else {
        float2 r = sample2(&rnd);
        float pj = par->view_clip.z;
        float x = (float)(pixel % par->nx) + 0.5f + pj * (0.5f - r.x);
        float y = (float)(par->ny - 1u - pixel / par->nx) + 0.5f + pj * (0.5f - r.y);
        float3 lens = F3(0.0f, 0.0f, 0.0f);
        if (par->view_clip.w > 0.0f) {
            r = sample2(&rnd);
            lens = F3(r.x, r.y, sample1(&rnd));
        }
        ok = view_lens_ray(par, x / (float)par->nx, y / (float)par->ny, lens, &ray);
    }
    a->rad[slot] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);
    if (!ok) return 0;
    uint4 info;
    info.x = 0u;
    info.y = rnd.key;
    info.z = rnd.index | (rnd.dim << 8);
    info.w = NONE;
    a->org[slot] = pack4(ray.org, as_float_(CLIP_START));
    a->dir[slot] = pack4(ray.dir, ray.tmax);
    a->thr[slot] = pack4(F3(1.0f, 1.0f, 1.0f), 1.0f);
    if (par->medium.w > 0.0f) {
        Medium open = medium_open(par);
        set_path_medium(a, slot, &open);
    }
    a->info[slot] = info;
    return 1;
}

FN void path_extend(PRIVATE const SceneTables* s, PRIVATE const Paths* a, uint slot) {
    Ray ray;
    Hit hit;
    float4 d = a->dir[slot];
    ray.org = xyz4(a->org[slot]);
    ray.dir = xyz4(d);
    ray.tmin = 0.0f;
    ray.tmax = d.w;
    trace_closest(s, &ray, RAY_ALL, &hit);
    float4 h;
    h.x = hit.t;
    h.y = as_float_(hit.prim);
    h.z = hit.u;
    h.w = hit.v;
    a->hit[slot] = h;
    a->info[slot].w = hit.inst;
}

FN float coefficient_weight(float3 c) {
    float m = max3(c);
    return m > 0.0f ? m : 0.0f;
}

// RADIANCE weights a rough lobe where its ray's weight earns it two samples or more, -ss times the weight; what several
// samples or a hemisphere of them sent out earns one (spec shading 3.4).
FN int lobe_weighted(PRIVATE const Params* par, uint flags, float weight) {
    return (flags & (PC_DIFFUSE | PC_ROUGH)) == 0u && par->ss * weight > 1.5f;
}

// Shades the hit of a slot.  Returns bit 0: the path goes on, bit 1: a shadow ray waits.
#define PATH_GOES_ON 1
#define PATH_SHADOW 2
FN int path_shade(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot) {
    uint4 info = a->info[slot];
    float4 h = a->hit[slot], t4 = a->thr[slot], r4 = a->rad[slot];
    float3 dir = xyz4(a->dir[slot]), org = xyz4(a->org[slot]), thr = xyz4(t4), rad = xyz4(r4);
    uint flags = info.x;
    Sampler rnd = path_sampler(info);
    Hit hit;
    hit.t = h.x;
    hit.prim = as_uint_(h.y);
    hit.u = h.z;
    hit.v = h.w;
    hit.inst = info.w;
    int wanted =
        class_wanted(par, flags, par->frame + (par->mode == MODE_RAY ? 0u : (par->first + slot) / (par->nx * par->ny)));
    int result = 0;

    if (hit.prim == NO_HIT) {
        if (par->medium.w > 0.0f) {  // a medium without end
            Medium m = path_medium(a, slot);
            float3 T = attenuation(m.k, 1e10f);
            if (wanted) rad = add3(rad, mul3(thr, medium_glow(par, &m, T)));
            thr = mul3(thr, T);
        }
        if (wanted && a->dir[slot].w >= 1e29f)
            rad = add3(rad, mul3(thr, path_background(s, par, org, dir, flags, &rnd)));
        a->rad[slot] = pack4(rad, r4.w);
        return 0;
    }
    Ray ray;
    Surface g;
    ray.org = org;
    ray.dir = dir;
    ray.tmin = 0.0f;
    ray.tmax = h.x;
    surface_at(s, &ray, &hit, &g);
    g.total = r4.w + h.x;
    uint step = flags >> PC_STEP_SHIFT;
    if (step >= PC_STEP_LIMIT) return 0;
    flags += 1u << PC_STEP_SHIFT;

    int pass = 0, absorbs = par->medium.w > 0.0f, emits = 0, scattered = 0;
    uint scatters = 0u;  // sources that the medium scatters
    Lobes lobes;
    float3 next = dir, emitted = F3(0.0f, 0.0f, 0.0f);
    // of the segment that ends here; of the way on through the surface
    Medium arriving = absorbs ? path_medium(a, slot) : medium_open(par), beyond = arriving;
    uint clip = as_uint_(a->org[slot].w), before = clip;  // antimatter beyond the surface and before it
    uint carried = g.mod;
    if (((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) ||
        !find_material(s, par, &g, &rnd) || take_alternate(s, par, &g, flags, &rnd)) {
        pass = 1;
    } else if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
        emitted = emitter_radiance(s, par, &g, flags, &pass);
        emits = !pass;
    } else {
        if (g.type == M_MIST) mist_crossing(s, par, &g, &arriving, &beyond);
        int asked = (flags & (PC_DIFFUSE | PC_ROUGH)) != 0u ? LOBES_SAMPLED : LOBES_EYE;
        if (g.type == M_MIST) lobes.flags = LOBE_PASS;
        else material_lobes(s, par, &g, asked, &rnd, &arriving, &beyond, &lobes);
        pass = (lobes.flags & LOBE_PASS) != 0u;
        if ((par->flags & PF_ANTIMATTER) != 0u) clip_turned(s, par, &g, carried, &clip);
        if ((par->flags & PF_IRRADIANCE) != 0u && (flags & (PC_BENT | PC_DIFFUSE | PC_ROUGH)) == 0u) {
            pass = pass || (mod_record(s, par, g.mod)[MOD_FLAGS] & MF_SEEN_THROUGH) != 0u;
            // what the material knows of media does not count
            if (absorbs) arriving = path_medium(a, slot);
            beyond = arriving;
            if (!pass) {
                float3 pi3 = F3(3.14159265f, 3.14159265f, 3.14159265f);
                g.pert = g.pert_before;  // the white surface in its place has no texture of its own
                shading_normal(&g);
                lobes_clear(&lobes);
                lobes.diffuse_r = pi3;
                lobes.ambient_r = pi3;
            }
        }
    }
    Medium crossed = arriving;
    if (absorbs && g.mixed) crossed = path_medium(a, slot);
    if (absorbs && max3(crossed.k) > 0.0f) {
        float3 T = attenuation(crossed.k, g.length);
        scatters = scattered_count(s, par, &crossed);
        if (wanted) rad = add3(rad, mul3(thr, medium_glow(par, &crossed, T)));
        if (wanted && scatters > 0u) {
            // one shadow ray a step: if it goes to the mist, the surface's own direct light is left to other samples
            float2 x = sample2(&rnd), y = sample2(&rnd);
            scattered = x.x >= 0.5f;
            if (scattered &&
                scatter_shadow(s, par, a, slot, org, dir, g.length, &crossed, scatters, before, thr, r4.w, x, y, &rnd))
                result |= PATH_SHADOW;
        }
        thr = mul3(thr, T);
    }
    if (emits) {
        if (wanted) rad = add3(rad, mul3(thr, emitted));
        a->rad[slot] = pack4(rad, r4.w);
        return result;
    }
    if (!pass) {
        // ---- light from active sources
        if (wanted && par->source_count > 0u) {
            uint i = 0u;
            float inv_p = choose_source(s, par, g.p, g.n, par->source_count > 1u && lobes_transmit(&lobes), &rnd, &i);
            float2 x = sample2(&rnd);
            if (scattered) inv_p = 0.0f;
            else if (scatters > 0u) inv_p *= 2.0f;
            if (inv_p > 0.0f) {
                LightSample ls;
                sample_source(s, par, i, g.p, x, par->dj, &ls);
                if (ls.w > 0.0f) {
                    float w = ls.w / ls.pieces;
                    float3 c = (lobes.flags & LOBE_ASHIK) != 0u  ? ashik_direct(&lobes, &g, ls.dir, w)
                               : (lobes.flags & LOBE_BSDF) != 0u ? bsdf_direct(s, par, &lobes, &g, ls.dir, w, &rnd)
                               : (lobes.flags & LOBE_OWN_NORMALS) != 0u ? wgmd_direct(&lobes, &g, ls.dir, w, par->dj)
                                                                        : lobes_direct(&lobes, &g, ls.dir, w, par->dj);
                    if ((lobes.flags & LOBE_FUNCTION) != 0u)
                        c = add3(c, function_direct(s, par, &lobes, &g, ls.dir, w));
                    c = scale3(c, ls.pieces);
                    if (max3(c) > 0.0f) {
                        GLOBAL const float* q = source_record(s, par, i);
                        float3 e = F3(1.0f, 1.0f, 1.0f);  // a virtual source's radiance is known where its ray arrives
                        if (as_uint_(q[SRC_VIRTUAL]) == NONE)
                            e = light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), ls.dir, ls.point,
                                               ls.normal, ls.dist, g.total + ls.dist, &rnd);
                        // where a pattern falls below 0 RADIANCE counts light whose luminance is above it
                        int lit = luminance3(mul3(c, e)) > 0.0f;
                        c = mul3(mul3(thr, c), scale3(e, inv_p));
                        int itself = as_uint_(q[SRC_PRIM]) == g.prim && as_uint_(q[SRC_VIRTUAL]) == NONE;  // an illum
                        if (lit && !itself) {
                            int above = dot3(ls.dir, g.ng) > 0.0f;
                            float3 start = bsdf_start(&lobes, &g, above),
                                   from = offset_ray(start, above ? g.ng : neg3(g.ng), g.reach);
                            if (ls.dist < 1e29f) {  // aimed anew from where it starts, else the source would stand in
                                                    // its own light
                                float3 to = sub3(scale3(ls.dir, ls.dist), sub3(from, start));
                                ls.dist = length3(to);
                                ls.dir = scale3(to, 1.0f / MAX_(ls.dist, 1e-9f));
                            }
                            a->sorg[slot] = pack4(from, as_float_(i));
                            a->sdir[slot] = pack4(ls.dir, ls.dist);
                            a->scol[slot] = pack4(c, g.total);
                            if (absorbs || (par->flags & PF_ANTIMATTER) != 0u)
                                set_shadow_medium(a, slot, above ? &arriving : &beyond, above ? before : clip);
                            result |= PATH_SHADOW;
                        }
                    }
                }
            }
        }
        // ---- one way to go on
        uint ab = (flags >> PC_AB_SHIFT) & 255u, level = (flags >> PC_LEVEL_SHIFT) & 255u;
        int more = (int)ab < par->ab;
        if (!more && wanted) {  // the reference's constant stands for deeper bounces (-av)
            float3 av = F3(par->av.x, par->av.y, par->av.z);
            rad = add3(rad, mul3(thr, mul3(add3(lobes.ambient_r, lobes.ambient_t), av)));
        }
        if (par->mode == MODE_DIRECT) more = 0;
        float w_mirror = coefficient_weight(lobes.mirror), w_through = coefficient_weight(lobes.through);
        float w_refract = coefficient_weight(lobes.refract);
        // a solid's surface shares out energy; that radiance is greater inside, by the index squared, does not matter
        if (w_refract > 0.0f && (g.type == M_DIELECTRIC || g.type == M_INTERFACE)) w_refract = 1.0f - w_mirror;
        float w_diff_r = more ? coefficient_weight(lobes.ambient_r) : 0.0f;
        float w_diff_t = more ? coefficient_weight(lobes.ambient_t) : 0.0f;
        float w_rough_r = (lobes.flags & LOBE_SAMPLE_R) != 0u ? coefficient_weight(lobes.rough_r) : 0.0f;
        float w_rough_t = (lobes.flags & LOBE_SAMPLE_T) != 0u ? coefficient_weight(lobes.rough_t) : 0.0f;
        float sum = w_mirror + w_through + w_refract + w_diff_r + w_diff_t + w_rough_r + w_rough_t;
        if (sum <= 0.0f) {
            a->rad[slot] = pack4(rad, r4.w);
            a->info[slot].z = rnd.index | (rnd.dim << 8);
            return result;
        }
        float r = sample1(&rnd) * sum, factor = 1.0f, p;
        float3 coef;
        int reflected = 1;
        if ((r -= w_diff_r) < 0.0f) {
            coef = lobes.ambient_r;
            p = w_diff_r;
            factor = sample_diffuse(s, par, g.p, g.n, &rnd, &next);
            if (dot3(next, g.ng) <= 0.0f) factor = 0.0f;
            flags |= PC_DIFFUSE;
            ab++;
        } else if ((r -= w_through) < 0.0f) {
            coef = lobes.through;
            p = w_through;
            next = lobes.through_dir;
            reflected = 0;
            if (dot3(next, g.v) > -0.99999f) flags |= PC_BENT;
        } else if ((r -= w_mirror) < 0.0f) {
            coef = lobes.mirror;
            p = w_mirror;
            next = lobes.mirror_dir;
            flags |= PC_BENT;
        } else if ((r -= w_rough_r) < 0.0f) {
            coef = lobes.rough_r;
            p = w_rough_r;
            if ((lobes.flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(&lobes, &g, WGMD_ROUGH_R);
            factor = (lobes.flags & LOBE_ASHIK) != 0u ? ashik_sample(&lobes, &g, &rnd, &next)
                     : (lobes.flags & LOBE_BSDF) != 0u
                         ? bsdf_sample_lobe(s, par, &lobes, &g, 0, &rnd, &coef, &next)
                         : lobes_sample_rough_r(&lobes, &g, &rnd, lobe_weighted(par, flags, t4.w), par->ss, &next);
            flags |= PC_ROUGH | PC_BENT;
        } else if ((r -= w_diff_t) < 0.0f) {
            coef = lobes.ambient_t;
            p = w_diff_t;
            if ((lobes.flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(&lobes, &g, WGMD_DIFFUSE_T);
            factor = sample_diffuse(s, par, g.p, neg3(g.n), &rnd, &next);
            if (dot3(next, g.ng) >= 0.0f) factor = 0.0f;
            flags |= PC_DIFFUSE;
            ab++;
        } else if ((r -= w_rough_t) < 0.0f) {
            coef = lobes.rough_t;
            p = w_rough_t;
            if ((lobes.flags & LOBE_OWN_NORMALS) != 0u) wgmd_turn(&lobes, &g, WGMD_ROUGH_T);
            factor = (lobes.flags & LOBE_BSDF) != 0u ? bsdf_sample_lobe(s, par, &lobes, &g, 1, &rnd, &coef, &next)
                                                     : lobes_sample_rough_t(&lobes, &g, &rnd, par->ss, &next);
            flags |= PC_ROUGH | PC_BENT;
            reflected = 0;
        } else {
            coef = lobes.refract;
            p = w_refract;
            next = lobes.refract_dir;
            reflected = 0;
            flags |= PC_BENT;
        }
        if (p <= 0.0f) factor = 0.0f;
        float3 side = dot3(next, g.ng) > 0.0f ? g.ng : neg3(g.ng);
        level += (uint)reflected;
        t4.w *= MIN_(1.0f, max3(coef));
        thr = scale3(mul3(thr, coef), factor * sum / MAX_(p, 1e-30f));
        int dead = factor <= 0.0f || max3(thr) <= 0.0f;
        if (par->lr > 0) dead = dead || (int)level > par->lr || t4.w < par->lw;
        else if (par->lr < 0) dead = dead || (int)level > -par->lr;
        // Russian roulette on what the surfaces reflect, not on the throughput: that also holds how likely the
        // direction was, and a way chosen toward a window is likely because much light is expected from it (spec
        // shading 6).
        if (!dead && ab >= 2u && t4.w < RR_START) {
            float q = MAX_(t4.w / RR_START, 0.05f);
            if (sample1(&rnd) >= q) dead = 1;
            else {
                thr = scale3(thr, 1.0f / q);
                t4.w /= q;
            }
        }
        a->rad[slot] = pack4(rad, dead ? r4.w : g.total);
        info.x = (flags & 0xff0000ffu) | (level << PC_LEVEL_SHIFT) | (ab << PC_AB_SHIFT);
        info.z = rnd.index | (rnd.dim << 8);
        a->info[slot] = info;
        if (dead) return result;
        if (absorbs) set_path_medium(a, slot, dot3(next, g.ng) > 0.0f ? &arriving : &beyond);
        int above = dot3(next, g.ng) > 0.0f;
        a->org[slot] =
            pack4(offset_ray(bsdf_start(&lobes, &g, above), side, g.reach), as_float_(above ? before : clip));
        a->dir[slot] = pack4(next, 1e30f);
        a->thr[slot] = pack4(thr, t4.w);
        return result | PATH_GOES_ON;
    }
    // ---- straight on, as if nothing were there
    a->rad[slot] = pack4(rad, g.total);
    info.x = flags;
    info.z = rnd.index | (rnd.dim << 8);
    a->info[slot] = info;
    if (absorbs) set_path_medium(a, slot, &beyond);
    a->thr[slot] = pack4(thr, t4.w);
    a->org[slot] = pack4(offset_ray(g.p, neg3(g.ng), g.reach), as_float_(clip));
    a->dir[slot] = pack4(dir, a->dir[slot].w >= 1e29f ? 1e30f : a->dir[slot].w - h.x);
    return result | PATH_GOES_ON;
}
#endif
