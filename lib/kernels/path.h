// SPDX-License-Identifier: BSD-3-Clause
// One path per slot, in four stages that run over queues (wavefront, Laine et al. 2013): generate, extend, shade, shadow.
// A path's class is "diffuse" once it has left a surface into the hemisphere (paper section 3; spec shading 0.2);
// frame 0 keeps the direct class, frames k >= 1 the diffuse one and, past the first m, both (spec paper 7).
#ifndef LUX_PATH_H
#define LUX_PATH_H

typedef struct {
    GLOBAL float4* org;    // xyz
    GLOBAL float4* dir;    // xyz, tmax
    GLOBAL float4* thr;    // rgb throughput, w = RADIANCE's ray weight (for -lw)
    GLOBAL float4* rad;    // rgb radiance gathered, w = path length from the eye
    GLOBAL uint4* info;    // flags, sampler key, index | dim << 8, instance
    GLOBAL float4* hit;    // t, prim (bits), u, v
    GLOBAL float4* sorg;   // shadow ray: origin, w = source index (bits)
    GLOBAL float4* sdir;   // direction, w = distance
    GLOBAL float4* scol;   // rgb of the contribution if unblocked
    GLOBAL float4* med;    // rgb extinction of the medium the ray travels in (used if Params.medium.w)
    GLOBAL float4* smed;   // the same for the shadow ray
} Paths;

// flags in info.x
#define PC_DIFFUSE 1u      // some ancestor was a hemisphere sample
#define PC_ROUGH 2u        // some ancestor was a rough-specular sample
#define PC_BENT 4u         // some reflection or refraction lies behind: not the eye's straight ray
#define PC_LEVEL_SHIFT 8u  // reflection level, 8 bits
#define PC_AB_SHIFT 16u    // diffuse depth, 8 bits
#define PC_STEP_SHIFT 24u  // surfaces met, 8 bits, saturating
#define PC_STEP_LIMIT 250u
#define RR_START 0.05f      // ray weight below which roulette sets in

FN float4 pack4(float3 v, float w) { float4 r; r.x = v.x; r.y = v.y; r.z = v.z; r.w = w; return r; }
FN float3 xyz4(float4 v) { return F3(v.x, v.y, v.z); }

// Participating media (spec shading 3.9).  A medium is an extinction rgb and, in w (bits), the mist last entered.
// Crossing a mist's surface changes it: k is the ray's extinction, seen by what scatter 0 (all of it) or 1 (shadow rays:
// without the albedo's share).
FN float4 mist_crossing(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g, float4 medium,
                        int shadow) {
    GLOBAL const float* arg = s->f + mod_record(s, par, g->mod)[MOD_ARGS];
    float3 k = mul3(F3(arg[0], arg[1], arg[2]), g->color);
    if (shadow) k = mul3(k, F3(1.0f - arg[3], 1.0f - arg[4], 1.0f - arg[5]));
    float sign = g->front ? 1.0f : -1.0f;
    float4 r;
    r.x = MAX_(medium.x + sign * k.x, 0.0f);
    r.y = MAX_(medium.y + sign * k.y, 0.0f);
    r.z = MAX_(medium.z + sign * k.z, 0.0f);
    r.w = as_float_(g->front ? g->mod : NONE);
    return r;
}
// Albedo and eccentricity of a medium: the mist's, else the global ones.
FN float3 medium_albedo(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mist, PRIVATE float* g) {
    if (mist == NONE) { *g = par->albedo.w; return F3(par->albedo.x, par->albedo.y, par->albedo.z); }
    GLOBAL const float* arg = s->f + mod_record(s, par, mist)[MOD_ARGS];
    *g = arg[6];
    return F3(arg[3], arg[4], arg[5]);
}

// What a medium of extinction k lets through over a length (Beer's law).
FN float3 attenuation(float3 k, float length) {
    if (max3(k) <= 0.0f) return F3(1.0f, 1.0f, 1.0f);
    return F3(k_exp(-k.x * length), k_exp(-k.y * length), k_exp(-k.z * length));
}

FN Sampler path_sampler(uint4 info) {
    Sampler s;
    s.key = info.y;
    s.index = info.z & 255u;
    s.dim = info.z >> 8;
    return s;
}

// 1 if the slot has a ray to follow.
FN int path_generate(PRIVATE const Params* par, PRIVATE const Paths* a, uint slot) {
    uint pixels = par->nx * par->ny, gid = par->first + slot;
    uint pixel = par->mode == MODE_RAY ? 0u : gid % pixels;
    uint index = par->frame + (par->mode == MODE_RAY ? gid : gid / pixels);
    // Frame 0's direct samples 0 .. m-1 and the sample k-1 of each later frame k are one sequence, so that the direct class
    // of L'(n) is the mean of its first n samples: full nets at 64, 128, ...
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
    info.x = 0u; info.y = rnd.key; info.z = rnd.index | (rnd.dim << 8); info.w = NONE;
    a->org[slot] = pack4(ray.org, as_float_(CLIP_START));
    a->dir[slot] = pack4(ray.dir, ray.tmax);
    a->thr[slot] = pack4(F3(1.0f, 1.0f, 1.0f), 1.0f);
    if (par->medium.w > 0.0f) a->med[slot] = pack4(xyz4(par->medium), as_float_(NONE));
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
    h.x = hit.t; h.y = as_float_(hit.prim); h.z = hit.u; h.w = hit.v;
    a->hit[slot] = h;
    a->info[slot].w = hit.inst;
}

// Whether this path's present class is wanted in this pass.
FN int class_wanted(PRIVATE const Params* par, uint flags, uint index) {
    if (par->mode == MODE_RAY) return 1;
    if ((flags & PC_DIFFUSE) != 0u) return par->mode == MODE_FRAMES;
    return par->mode == MODE_DIRECT || index > par->skip_direct_below;
}

// What a ray that met nothing sees: sun, sky, ground glow.
FN float3 path_background(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 org, float3 dir, uint flags,
                          PRIVATE Sampler* rnd) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    uint i = distant_at(s, par, dir);
    if (i == NONE) return black;
    GLOBAL const uint* q = s->u + par->distant_at + DISTANT_WORDS * i;
    uint src = q[DISTANT_SOURCE];
    if (src != NONE) {  // an active source (the sun): only eye and mirror rays see it (spec shading 0.1)
        if ((flags & (PC_DIFFUSE | PC_ROUGH)) != 0u || (par->flags & PF_DV) == 0u) return black;
        if ((flags & PC_BENT) == 0u && par->mode != MODE_RAY &&
            as_uint_(source_record(s, par, src)[SRC_DRAWN]) != 0u) return black;  // frame 0 holds it by area
    }
    return light_radiance(s, par, q[DISTANT_MOD], NONE, dir, org, neg3(dir), 1e30f, 1e30f, rnd);
}

// Radiance of a light surface at a hit (spec shading 3.8, in its order).  *pass = 1: the ray goes on through it.
FN float3 emitter_radiance(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g, uint flags,
                           PRIVATE int* pass) {
    float3 black = F3(0.0f, 0.0f, 0.0f);
    GLOBAL const uint* m = mod_record(s, par, g->mod);
    GLOBAL const float* arg = s->f + m[MOD_ARGS];
    uint src = s->prims[PRIM_WORDS * g->prim + PRIM_SOURCE];
    *pass = 0;
    if (!g->front) { *pass = par->bv == 0u; return black; }
    if ((flags & (PC_DIFFUSE | PC_ROUGH)) != 0u) {
        if (g->type != M_GLOW || arg[3] < 0.0f) return black;
        if (arg[3] > 0.0f && g->length <= arg[3]) return black;
    } else {
        if ((par->flags & PF_DV) == 0u && !(g->type == M_GLOW && arg[3] >= 0.0f && g->total > arg[3])) return black;
        if (src != NONE && (flags & PC_BENT) == 0u && par->mode != MODE_RAY &&
            as_uint_(source_record(s, par, src)[SRC_DRAWN]) != 0u) return black;
    }
    if (g->type == M_SPOTLIGHT) {
        float3 aim = f3_at(arg + 4);
        if (dot3(unit3(aim), g->v) < k_cos(arg[3] * 0.5f * 0.01745329252f)) return black;
    }
    return mul3(g->color, f3_at(arg));
}

// Fills lobes for the material at g.  asked: LOBES_*; for shadows only what lets light pass is needed.  *arriving: medium of the segment that
// ended here, corrected where the surface knows it; *beyond: medium behind the surface.
FN void material_lobes(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE Surface* g, int asked,
                       PRIVATE Sampler* rnd, PRIVATE float3* arriving, PRIVATE float3* beyond, PRIVATE Lobes* l) {
    GLOBAL const uint* m = mod_record(s, par, g->mod);
    GLOBAL const float* arg = s->f + m[MOD_ARGS];
    float vars[CAL_VARS], value[CAL_OUTPUTS];
    uint type = g->type;
    lobes_clear(l);
    *beyond = *arriving;
    if (!g->front && par->bv == 0u && type != M_DIELECTRIC && type != M_INTERFACE && type != M_BRTD && type != M_PRISM) { l->flags |= LOBE_PASS; return; }
    if ((m[MOD_FLAGS] & MF_VALUES) != 0u) {  // functions evaluated once per hit
        material_vars(par, g, vars);
        vars_to_frame(s, g, vars);
        if (cal_run(s, m[MOD_PROGRAM], vars, value))
            for (int i = 0; i < CAL_OUTPUTS; i++) value[i] = 0.0f;
        values_from_frame(s, g, m[MOD_FLAGS], value);
    }
    switch (type) {
    case M_PLASTIC: case M_METAL: case M_TRANS:
        mat_normal(par, g, type, arg, F3(0.0f, 0.0f, 0.0f), l);
        break;
    case M_GLASS: mat_glass(g, arg, asked == LOBES_SHADOW, l); break;
    case M_ANISO_PLASTIC: case M_ANISO_METAL: case M_ANISO_TRANS:
        mat_normal(par, g, type, arg, F3(value[0], value[1], value[2]), l);
        break;
    case M_ASHIK: mat_ashik(par, g, arg, F3(value[0], value[1], value[2]), l); break;
    case M_BRDF: mat_brdf(g, arg, m[MOD_FLAGS], l); break;
    case M_BRTD: mat_brtd(g, arg, value, l); break;
    case M_WGMD: mat_wgmd(s, par, g, m, value, rnd, l); break;
    case M_BSDF: mat_bsdf(s, par, g, m, value, asked, rnd, l); break;
    case M_DIELECTRIC: case M_INTERFACE:
        mat_dielectric(par, g, type, arg, l, arriving, beyond);
        break;
    case M_PRISM:
        if (asked != LOBES_SHADOW) mat_prism(m[MOD_FLAGS], value, l);  // shadow rays pass by virtual sources only (shadow_aimed)
        break;
    case M_MIRROR:
        if (g->front) { l->mirror = mul3(f3_at(arg), g->color); l->mirror_dir = mirror_direction(g); }
        break;
    default: break;
    }
}

// illum and mirror may name an alternate material (spec shading 3.7, 3.8).  If it acts for this ray, g becomes the
// alternate.  1: the ray passes instead.
FN int take_alternate(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE Surface* g, uint flags,
                      PRIVATE Sampler* rnd) {
    GLOBAL const uint* m = mod_record(s, par, g->mod);
    int sampled = (flags & (PC_DIFFUSE | PC_ROUGH)) != 0u;
    uint alternate = m[MOD_BRANCH1];
    if (g->type == M_ILLUM) {
        if (g->front && sampled) return 0;  // black to sampled rays: their light comes from the source
    } else if (g->type == M_MIRROR) {
        if ((m[MOD_FLAGS] & MF_HAS_ALTERNATE) == 0u) return 0;
        if (g->front && sampled && (m[MOD_FLAGS] & MF_ALTERNATE_PASSES) == 0u) return 0;
    } else {
        return 0;
    }
    if (alternate == NONE) return 1;
    g->mod = alternate;
    g->color = F3(1.0f, 1.0f, 1.0f);
    g->pert = F3(0.0f, 0.0f, 0.0f);
    g->n = g->ng;
    return !find_material(s, par, g, rnd);
}

// Transparent materials that irradiance pictures look through, as found with rtrace -i+ (spec shading 5.5).
FN int irradiance_ignores(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Surface* g,
                          PRIVATE const Lobes* l) {
    switch (g->type) {
    case M_TRANS: case M_ANISO_TRANS: case M_GLASS: case M_DIELECTRIC: case M_INTERFACE: case M_MIST: case M_ANTIMATTER: return 1;
    case M_BSDF: return (mod_record(s, par, g->mod)[MOD_FLAGS] & MF_ABSDF) != 0u;
    case M_BRTD: case M_WGMD: return max3(l->through) > 0.0f || max3(l->diffuse_t) > 0.0f || max3(l->rough_t) > 0.0f;
    default: return 0;
    }
}

FN float coefficient_weight(float3 c) { float m = max3(c); return m > 0.0f ? m : 0.0f; }

// A mist may name sources whose light it scatters once into the ray (list: count, source indices).
FN int mist_scatters(PRIVATE const SceneTables* s, PRIVATE const Params* par, uint mist) {
    uint list = mod_record(s, par, mist)[MOD_EXTRA];
    return list != NONE && list != 0u && s->u[list] > 0u;
}

// Single scattering along a segment that ends after `length`: a random point of it, a random source of the mist; with
// Henyey and Greenstein's phase function (spec shading 3.9).  Half of the steps do this, half light the surface.
FN int scatter_shadow(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot, float3 org,
                      float3 dir, float length, float3 k, float3 albedo, float ecc, uint mist, float3 thr, float total,
                      PRIVATE Sampler* rnd) {
    if (!mist_scatters(s, par, mist)) return 0;
    float2 x = sample2(rnd), y = sample2(rnd);
    if (x.x < 0.5f) return 0;
    uint list = mod_record(s, par, mist)[MOD_EXTRA], count = s->u[list];
    uint pick = (uint)((2.0f * x.x - 1.0f) * (float)count);
    pick = s->u[list + 1u + MIN_(pick, count - 1u)];
    float t = x.y * length;
    float3 p = madd3(dir, t, org);
    LightSample ls;
    sample_source(s, par, pick, p, y, par->dj, &ls);
    if (ls.w <= 0.0f) return 0;
    GLOBAL const float* q = source_record(s, par, pick);
    float3 e = light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), ls.dir, ls.point, ls.normal, ls.dist,
                              total + t + ls.dist, rnd);
    float c = dot3(ls.dir, dir), d = 1.0f + ecc * ecc - 2.0f * ecc * c;
    float phase = (1.0f - ecc * ecc) / (d * sqrt_(d)) * 0.0795774715f;
    float3 w = mul3(mul3(mul3(k, albedo), attenuation(k, t)), mul3(thr, e));
    w = scale3(w, 2.0f * (float)count * length * phase * ls.w);
    if (max3(w) <= 0.0f) return 0;
    a->sorg[slot] = pack4(p, as_float_(pick));
    a->sdir[slot] = pack4(ls.dir, ls.dist);
    a->scol[slot] = pack4(w, total + t);
    a->smed[slot] = pack4(mul3(k, sub3(F3(1.0f, 1.0f, 1.0f), albedo)), 0.0f);
    return 1;
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
    hit.t = h.x; hit.prim = as_uint_(h.y); hit.u = h.z; hit.v = h.w; hit.inst = info.w;
    int wanted = class_wanted(par, flags, par->frame + (par->mode == MODE_RAY ? 0u : (par->first + slot) / (par->nx * par->ny)));
    int result = 0;

    if (hit.prim == NO_HIT) {
        if (par->medium.w > 0.0f) thr = mul3(thr, attenuation(xyz4(a->med[slot]), 1e10f));  // a medium without end
        if (wanted && a->dir[slot].w >= 1e29f)
            a->rad[slot] = pack4(add3(rad, mul3(thr, path_background(s, par, org, dir, flags, &rnd))), r4.w);
        return 0;
    }
    Ray ray;
    Surface g;
    ray.org = org; ray.dir = dir; ray.tmin = 0.0f; ray.tmax = h.x;
    surface_at(s, &ray, &hit, &g);
    g.total = r4.w + h.x;
    uint step = flags >> PC_STEP_SHIFT;
    if (step >= PC_STEP_LIMIT) return 0;
    flags += 1u << PC_STEP_SHIFT;

    int pass = 0, absorbs = par->medium.w > 0.0f, mist_surface = 0, scattered = 0;
    Lobes lobes;
    float3 next = dir, arriving = F3(0.0f, 0.0f, 0.0f), beyond = arriving;
    float4 medium = pack4(arriving, 0.0f);
    uint mist = NONE;
    if (absorbs) { medium = a->med[slot]; arriving = xyz4(medium); beyond = arriving; mist = as_uint_(medium.w); }
    uint clip = as_uint_(a->org[slot].w);
    if (((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) ||
        !find_material(s, par, &g, &rnd) || take_alternate(s, par, &g, flags, &rnd)) {
        pass = 1;
    } else if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
        float3 e = emitter_radiance(s, par, &g, flags, &pass);
        if (!pass) {
            if (absorbs) thr = mul3(thr, attenuation(arriving, g.length));
            if (wanted) a->rad[slot] = pack4(add3(rad, mul3(thr, e)), r4.w);
            return 0;
        }
    } else {
        mist_surface = g.type == M_MIST;
        if (!mist_surface) material_lobes(s, par, &g, (flags & (PC_DIFFUSE | PC_ROUGH)) != 0u ? LOBES_SAMPLED : LOBES_EYE, &rnd, &arriving, &beyond, &lobes);
        else lobes.flags = LOBE_PASS;
        pass = (lobes.flags & LOBE_PASS) != 0u;
        if ((par->flags & PF_IRRADIANCE) != 0u && (flags & (PC_BENT | PC_DIFFUSE | PC_ROUGH)) == 0u) {
            pass = pass || irradiance_ignores(s, par, &g, &lobes);
            mist_surface = 0;
            if (!pass) {
                float3 pi3 = F3(3.14159265f, 3.14159265f, 3.14159265f);
                lobes_clear(&lobes);
                lobes.diffuse_r = pi3;
                lobes.ambient_r = pi3;
            }
        }
    }
    if (absorbs && max3(arriving) > 0.0f) {
        float ecc;
        float3 T = attenuation(arriving, g.length), av = F3(par->av.x, par->av.y, par->av.z);
        float3 albedo = medium_albedo(s, par, mist, &ecc);
        if (wanted) rad = add3(rad, mul3(thr, mul3(mul3(albedo, av), sub3(F3(1.0f, 1.0f, 1.0f), T))));  // spec shading 3.9
        if (wanted && mist != NONE && scatter_shadow(s, par, a, slot, org, dir, g.length, arriving, albedo, ecc, mist, thr, r4.w, &rnd)) {
            // one shadow ray a step: here it goes to the mist, so the surface's own direct light is left to other samples
            result |= PATH_SHADOW;
            scattered = 1;
        }
        thr = mul3(thr, T);
    }
    if (mist_surface) medium = mist_crossing(s, par, &g, medium, 0);
    if (!pass) {
        // ---- light from active sources
        if (wanted && par->source_count > 0u) {
            uint i = 0u;
            float inv_p = choose_source(s, par, g.p, &rnd, &i);
            float2 x = sample2(&rnd);
            if (scattered) inv_p = 0.0f;
            else if (mist != NONE && mist_scatters(s, par, mist)) inv_p *= 2.0f;
            if (inv_p > 0.0f) {
                LightSample ls;
                sample_source(s, par, i, g.p, x, par->dj, &ls);
                if (ls.w > 0.0f) {
                    float3 c = (lobes.flags & LOBE_ASHIK) != 0u ? ashik_direct(&lobes, &g, ls.dir, ls.w)
                               : (lobes.flags & LOBE_BSDF) != 0u ? bsdf_direct(s, par, &lobes, &g, ls.dir, ls.w, &rnd)
                                                                 : lobes_direct(&lobes, &g, ls.dir, ls.w, par->dj);
                    if ((lobes.flags & LOBE_FUNCTION) != 0u) c = add3(c, function_direct(s, par, &lobes, &g, ls.dir, ls.w));
                    if (max3(c) > 0.0f) {
                        GLOBAL const float* q = source_record(s, par, i);
                        float3 e = F3(1.0f, 1.0f, 1.0f);  // a virtual source's radiance is known where its ray arrives
                        if (as_uint_(q[SRC_VIRTUAL]) == NONE)
                            e = light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), ls.dir, ls.point,
                                               ls.normal, ls.dist, g.total + ls.dist, &rnd);
                        c = mul3(mul3(thr, c), scale3(e, inv_p));
                        if (max3(c) > 0.0f) {
                            int above = dot3(ls.dir, g.ng) > 0.0f;
                            a->sorg[slot] = pack4(offset_ray(bsdf_start(&lobes, &g, above), above ? g.ng : neg3(g.ng), g.reach), as_float_(i));
                            a->sdir[slot] = pack4(ls.dir, ls.dist);
                            a->scol[slot] = pack4(c, g.total);
                            if ((par->flags & PF_ANTIMATTER) != 0u) a->smed[slot] = pack4(F3(0.0f, 0.0f, 0.0f), as_float_(clip));
                            if (absorbs) {
                                float ecc;
                                float3 one = F3(1.0f, 1.0f, 1.0f), albedo = medium_albedo(s, par, mist, &ecc);
                                a->smed[slot] = pack4(mul3(above ? arriving : beyond, sub3(one, albedo)), as_float_(clip));
                            }
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
            coef = lobes.ambient_r; p = w_diff_r;
            factor = sample_diffuse(s, par, g.p, g.n, &rnd, &next);
            if (dot3(next, g.ng) <= 0.0f) factor = 0.0f;
            flags |= PC_DIFFUSE; ab++;
        } else if ((r -= w_through) < 0.0f) {
            coef = lobes.through; p = w_through; next = lobes.through_dir; reflected = 0;
            if (dot3(next, g.v) > -0.99999f) flags |= PC_BENT;
        } else if ((r -= w_mirror) < 0.0f) {
            coef = lobes.mirror; p = w_mirror; next = lobes.mirror_dir; flags |= PC_BENT;
        } else if ((r -= w_rough_r) < 0.0f) {
            coef = lobes.rough_r; p = w_rough_r;
            factor = (lobes.flags & LOBE_ASHIK) != 0u
                         ? ashik_sample(&lobes, &g, &rnd, &next)
                     : (lobes.flags & LOBE_BSDF) != 0u
                         ? bsdf_sample_lobe(s, par, &lobes, &g, 0, &rnd, &coef, &next)
                         : lobes_sample_rough_r(&lobes, &g, &rnd, (par->flags & PF_WEIGHTED) != 0u, par->ss, &next);
            flags |= PC_ROUGH | PC_BENT;
        } else if ((r -= w_diff_t) < 0.0f) {
            coef = lobes.ambient_t; p = w_diff_t;
            factor = sample_diffuse(s, par, g.p, neg3(g.n), &rnd, &next);
            if (dot3(next, g.ng) >= 0.0f) factor = 0.0f;
            flags |= PC_DIFFUSE; ab++;
        } else if ((r -= w_rough_t) < 0.0f) {
            coef = lobes.rough_t; p = w_rough_t;
            factor = (lobes.flags & LOBE_BSDF) != 0u
                         ? bsdf_sample_lobe(s, par, &lobes, &g, 1, &rnd, &coef, &next)
                         : lobes_sample_rough_t(&lobes, &g, &rnd, par->ss, &next);
            flags |= PC_ROUGH | PC_BENT; reflected = 0;
        } else {
            coef = lobes.refract; p = w_refract; next = lobes.refract_dir; reflected = 0;
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
        // Russian roulette on what the surfaces reflect, not on the throughput: that also holds how likely the direction
        // was, and a way chosen toward a window is likely because much light is expected from it (spec shading 6).
        if (!dead && ab >= 2u && t4.w < RR_START) {
            float q = MAX_(t4.w / RR_START, 0.05f);
            if (sample1(&rnd) >= q) dead = 1; else { thr = scale3(thr, 1.0f / q); t4.w /= q; }
        }
        a->rad[slot] = pack4(rad, dead ? r4.w : g.total);
        info.x = (flags & 0xff0000ffu) | (level << PC_LEVEL_SHIFT) | (ab << PC_AB_SHIFT);
        info.z = rnd.index | (rnd.dim << 8);
        a->info[slot] = info;
        if (dead) return result;
        if (absorbs) a->med[slot] = pack4(dot3(next, g.ng) > 0.0f ? arriving : beyond, medium.w);
        a->org[slot] = pack4(offset_ray(bsdf_start(&lobes, &g, dot3(next, g.ng) > 0.0f), side, g.reach), as_float_(clip));
        a->dir[slot] = pack4(next, 1e30f);
        a->thr[slot] = pack4(thr, t4.w);
        return result | PATH_GOES_ON;
    }
    // ---- straight on, as if nothing were there
    a->rad[slot] = pack4(rad, g.total);
    info.x = flags;
    info.z = rnd.index | (rnd.dim << 8);
    a->info[slot] = info;
    if (absorbs) a->med[slot] = medium;
    a->thr[slot] = pack4(thr, t4.w);
    a->org[slot] = pack4(offset_ray(g.p, neg3(g.ng), g.reach), as_float_(clip));
    a->dir[slot] = pack4(dir, a->dir[slot].w >= 1e29f ? 1e30f : a->dir[slot].w - h.x);
    return result | PATH_GOES_ON;
}

// What a shadow ray lets through: straight through glass, smooth trans, mixtures with void (spec shading 4.5).
FN float3 shadow_straight(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 org, float3 dir, float dist,
                          uint source, float3 medium, uint clip, PRIVATE Sampler* rnd) {
    float3 T = F3(1.0f, 1.0f, 1.0f), black = F3(0.0f, 0.0f, 0.0f), beyond;
    GLOBAL const float* q = source_record(s, par, source);
    uint kind = as_uint_(q[SRC_KIND]);
    Ray ray;
    ray.org = org; ray.dir = dir; ray.tmin = 0.0f;
    ray.tmax = dist >= 1e29f ? 1e30f : shadow_end(dist);
    int must_hit = par->ds > 0.0f && (kind == SK_POLYGON || kind == SK_RING || kind == SK_CYLINDER);
    if (kind == SK_SPHERE || kind == SK_CYLINDER || must_hit) {
        // near its outline a round source may stand in its own light; with -ds RADIANCE aims beside odd shapes, too
        Hit hit;
        if (must_hit) ray.tmax = dist * 1.001f;
        trace_closest(s, &ray, RAY_OPAQUE, &hit);
        if (hit.prim != as_uint_(q[SRC_PRIM]) && (must_hit || hit.prim != NO_HIT)) return black;
        ray.tmax = shadow_end(dist);
    } else if (trace_any(s, &ray, RAY_OPAQUE)) {
        return black;
    }
    int absorbs = par->medium.w > 0.0f;
    float4 m4 = pack4(medium, 0.0f);
    if (par->shadow_mode == SHADOW_OPAQUE) return absorbs ? attenuation(medium, MIN_(dist, 1e10f)) : T;
    float total = 0.0f;
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes l;
        trace_closest(s, &ray, RAY_TRANSPARENT, &hit);
        if (hit.prim == NO_HIT) return absorbs ? mul3(T, attenuation(xyz4(m4), MIN_(ray.tmax, 1e10f))) : T;
        if (absorbs) T = mul3(T, attenuation(xyz4(m4), hit.t));
        surface_at(s, &ray, &hit, &g);
        total += hit.t;
        g.total = total;
        if (!((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) &&
            find_material(s, par, &g, rnd)) {
            if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
                if (g.type != M_ILLUM) return black;
            } else if (g.type == M_MIST) {
                m4 = mist_crossing(s, par, &g, m4, 1);
            } else {
                material_lobes(s, par, &g, LOBES_SHADOW, rnd, &medium, &beyond, &l);
                if ((l.flags & LOBE_PASS) == 0u) T = mul3(T, l.through);
            }
            if (max3(T) <= 0.0f) return black;
        }
        ray.org = offset_ray(g.p, neg3(g.ng), g.reach);
        if (ray.tmax < 1e29f) { ray.tmax -= hit.t; if (ray.tmax <= 0.0f) return T; }
    }
    return black;
}

// The same where light may bend (dielectric) or be relayed (mirror): followed surface by surface; it must arrive at the
// real source aimed at (spec shading 3.6, 4.6).  For virtual sources the result holds the source's radiance.
FN float3 shadow_aimed(PRIVATE const SceneTables* s, PRIVATE const Params* par, float3 org, float3 dir, float total,
                       uint source, float3 medium, uint clip, PRIVATE Sampler* rnd) {
    float3 T = F3(1.0f, 1.0f, 1.0f), black = F3(0.0f, 0.0f, 0.0f), beyond;
    GLOBAL const float* q = source_record(s, par, source);
    int is_virtual = as_uint_(q[SRC_VIRTUAL]) != NONE, bent = 0;
    Ray ray;
    ray.org = org; ray.dir = dir; ray.tmin = 0.0f; ray.tmax = 1e30f;
    for (uint i = 0u; i < PC_STEP_LIMIT; i++) {
        Hit hit;
        Surface g;
        Lobes l;
        uint relay = as_uint_(q[SRC_VIRTUAL]);
        trace_closest(s, &ray, RAY_ALL, &hit);
        if (hit.prim == NO_HIT) {
            if (relay != NONE || as_uint_(q[SRC_KIND]) != SK_DISTANT) return black;
            float3 e = sub3(ray.dir, f3_at(q + SRC_CENTRE));
            if (par->medium.w > 0.0f) T = mul3(T, attenuation(medium, 1e10f));
            if ((bent || is_virtual) && 0.5f * dot3(e, e) > q[SRC_CAP]) return black;
            if (!is_virtual) return T;
            return mul3(T, light_radiance(s, par, as_uint_(q[SRC_MOD]), NONE, ray.dir, ray.org, neg3(ray.dir), 1e30f, 1e30f, rnd));
        }
        surface_at(s, &ray, &hit, &g);
        total += hit.t;
        g.total = total;
        if (par->medium.w > 0.0f && max3(medium) > 0.0f) T = mul3(T, attenuation(medium, hit.t));
        if (relay == NONE && hit.prim == as_uint_(q[SRC_PRIM])) {
            if (!g.front) return black;
            if (!is_virtual) return T;
            return mul3(T, light_radiance(s, par, as_uint_(q[SRC_MOD]), hit.prim, ray.dir, g.p, g.nface, hit.t, total, rnd));
        }
        float3 next = ray.dir;
        if (!((par->flags & PF_ANTIMATTER) != 0u && clip_hit(s, par, &g, &clip) == CLIP_IGNORE) &&
            find_material(s, par, &g, rnd)) {
            if (g.type >= M_LIGHT && g.type <= M_ILLUM) {
                if (g.type != M_ILLUM) return black;
            } else if (g.type == M_MIST) {
                medium = xyz4(mist_crossing(s, par, &g, pack4(medium, 0.0f), 1));
            } else {
                float3 known = medium;
                material_lobes(s, par, &g, LOBES_SHADOW, rnd, &known, &beyond, &l);
                if ((l.flags & LOBE_PASS) == 0u) {
                    if (relay != NONE && hit.prim == s->u[relay]) {  // the relay this virtual source belongs to
                        q = source_record(s, par, s->u[relay + 1u]);
                        if (g.type == M_PRISM) {
                            float3 aim = f3_at(q + SRC_CENTRE);
                            if (as_uint_(q[SRC_KIND]) != SK_DISTANT) aim = unit3(sub3(aim, g.p));
                            T = scale3(T, prism_exit(s, par, &g, aim, s->u[relay + 6u], &next));
                        } else {
                            T = mul3(T, l.mirror);
                            next = sub3(scale3(g.ng, 2.0f * dot3(g.ng, g.v)), g.v);  // textures do not act here
                        }
                    } else if (max3(l.refract) > 0.0f) {
                        T = mul3(T, l.refract);
                        next = l.refract_dir;
                        bent = 1;
                    } else {
                        T = mul3(T, l.through);
                    }
                    if (dot3(next, g.ng) < 0.0f) medium = beyond;
                }
            }
            if (max3(T) <= 0.0f) return black;
        }
        ray.org = offset_ray(g.p, dot3(next, g.ng) > 0.0f ? g.ng : neg3(g.ng), g.reach);
        ray.dir = next;
    }
    return black;
}

FN void path_shadow(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot) {
    float4 o = a->sorg[slot], d = a->sdir[slot], c = a->scol[slot];
    uint4 info = a->info[slot];
    Sampler rnd = path_sampler(info);
    rnd.key = hash_(rnd.key ^ 0x5bd1e995u);
    float3 T, medium = F3(0.0f, 0.0f, 0.0f);
    uint clip = (par->flags & PF_ANTIMATTER) != 0u ? as_uint_(a->smed[slot].w) : CLIP_START;
    if (par->medium.w > 0.0f) medium = xyz4(a->smed[slot]);
    if (par->shadow_mode == SHADOW_AIMED) {
        T = shadow_aimed(s, par, xyz4(o), xyz4(d), c.w, as_uint_(o.w), medium, clip, &rnd);
    } else {
        T = shadow_straight(s, par, xyz4(o), xyz4(d), d.w, as_uint_(o.w), medium, clip, &rnd);
    }
    float4 r = a->rad[slot];
    a->rad[slot] = pack4(add3(xyz4(r), mul3(xyz4(c), T)), r.w);
}

// MODE_DRAW: slot i holds a straight ray from the eye to a point of a source and its weight, written by the host into
// sorg, sdir, scol; the source's own radiance is applied here, path_shadow follows.
FN void path_draw(PRIVATE const SceneTables* s, PRIVATE const Params* par, PRIVATE const Paths* a, uint slot) {
    uint i = as_uint_(a->sorg[slot].w);
    GLOBAL const float* q = source_record(s, par, i);
    float3 org = xyz4(a->sorg[slot]), dir = xyz4(a->sdir[slot]);
    float dist = a->sdir[slot].w;
    Sampler rnd = sampler_start(par->seed_lo, par->seed_hi, slot + par->first, 0u, 3u);
    float3 normal = neg3(dir), point = org;
    if (as_uint_(q[SRC_KIND]) != SK_DISTANT) {
        point = madd3(dir, dist, org);
        normal = as_uint_(q[SRC_KIND]) == SK_SPHERE ? unit3(sub3(point, f3_at(q + SRC_CENTRE))) : f3_at(q + SRC_NORMAL);
    }
    float3 e = light_radiance(s, par, as_uint_(q[SRC_MOD]), as_uint_(q[SRC_PRIM]), dir, point, normal, dist, dist, &rnd);
    a->scol[slot] = pack4(mul3(xyz4(a->scol[slot]), e), 0.0f);
    a->rad[slot] = pack4(F3(0.0f, 0.0f, 0.0f), 0.0f);
    a->smed[slot] = pack4(xyz4(par->medium), as_float_(CLIP_START));
    uint4 info;
    info.x = 0u; info.y = rnd.key; info.z = rnd.index; info.w = NONE;
    a->info[slot] = info;
}
#endif
