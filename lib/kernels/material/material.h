// SPDX-License-Identifier: BSD-3-Clause
// From a material record to its lobes.  To add a material: CONTRIBUTING.md.
#ifndef LUX_MATERIAL_H
#define LUX_MATERIAL_H

#include "kernels/material/mat_normal.h"
#include "kernels/material/mat_glass.h"
#include "kernels/material/mat_dielectric.h"
#include "kernels/material/mat_function.h"
#include "kernels/material/mat_wgmd.h"
#include "kernels/material/mat_prism.h"
#include "kernels/material/mat_bsdf.h"

// With -bv-: returns 1 if the back of this type is invisible to this kind of ray.
FN int back_passes(uint type, int asked) {
    if (material_has(type, MT_NO_BACK) != 0u) return 0;
    return asked != LOBES_SHADOW || material_has(type, MT_OPEN_BACK) != 0u;
}

// Materials whose lobes are .cal functions or tables.  Functions are evaluated once per hit.
FN void function_lobes(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g, int asked,
                       PRIVATE(Sampler) rnd, PRIVATE(Lobes) lobes) {
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    GLOBAL const float* arg = s->f + m->args;
    float vars[CAL_VARS], value[CAL_OUTPUTS];

    if ((m->flags & MF_VALUES) != 0u) {
        material_vars(par, g, vars);
        vars_to_frame(s, g, vars);
        if (cal_run(s, m->program, vars, value))
            for (int i = 0; i < CAL_OUTPUTS; i++) value[i] = 0.0f;
        values_from_frame(s, g, m->flags, value);
    }

    switch (g->type) {
    case M_ANISO_PLASTIC:
    case M_ANISO_METAL:
    case M_ANISO_TRANS: mat_normal(par, g, g->type, arg, F3(value[0], value[1], value[2]), lobes); break;
    case M_ASHIK: mat_ashik(par, g, arg, F3(value[0], value[1], value[2]), lobes); break;
    case M_BRDF: mat_brdf(g, arg, m->flags, lobes); break;
    case M_BRTD: mat_brtd(g, arg, value, lobes); break;
    case M_WGMD: mat_wgmd(s, par, g, m, value, rnd, lobes); break;
    case M_BSDF: mat_bsdf(s, par, g, m, value, asked, rnd, lobes); break;
    case M_PRISM:
        if (asked != LOBES_SHADOW)
            mat_prism(m->flags, value, lobes);  // shadow rays pass by virtual sources only (shadow_aimed)
        break;
    default: break;
    }
}

// Fills lobes for the material at g.  asked: LOBES_*; for shadow rays only transmittance is needed.  *arriving and
// *medium_behind come as the media of the ray, and the surface corrects them: the segment that ends here, and the
// medium behind the surface.
FN void material_lobes(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g, int asked,
                       PRIVATE(Sampler) rnd, PRIVATE(Medium) arriving, PRIVATE(Medium) medium_behind,
                       PRIVATE(Lobes) lobes) {
    GLOBAL const float* arg = s->f + s->modifiers[g->mod].args;
    uint type = g->type;
    lobes_clear(lobes);
    if (!g->front && par->bv == 0u && back_passes(type, asked)) {
        lobes->flags |= LOBE_PASS;
        return;
    }

    switch (type) {
    case M_PLASTIC:
    case M_METAL:
    case M_TRANS: mat_normal(par, g, type, arg, F3(0.0f, 0.0f, 0.0f), lobes); break;
    case M_GLASS: mat_glass(g, arg, asked == LOBES_SHADOW, lobes); break;
    case M_DIELECTRIC:
    case M_INTERFACE:
        if (HAS(SOLIDS)) mat_dielectric(par, g, type, arg, lobes, arriving, medium_behind);
        break;
    case M_MIRROR:
        if (g->front) lobes_mirror(g, mul3(f3_at(arg), g->color), lobes);
        break;
    default:
        if (HAS(FUNCTIONS)) function_lobes(s, par, g, asked, rnd, lobes);
        break;
    }
}

// ---- illum and mirror may name an alternate material (spec shading 3.7, 3.8)

// g becomes the alternate, with the patterns and textures above the illum or mirror itself.  Returns 0 if the alternate
// is void and the ray passes.
FN int become_alternate(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g,
                        PRIVATE(Sampler) rnd) {
    uint alternate = s->modifiers[g->mod].branch1;
    if (alternate == NONE) return 0;
    g->mod = alternate;
    without_own_chain(s, g);
    return find_material(s, par, g, rnd);
}

// Returns 1 if the alternate replaces the material for a ray that is not aimed at a source.
FN int alternate_acts(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, uint flags) {
    int sampled = (flags & (PC_DIFFUSE | PC_ROUGH)) != 0u;
    if (g->type == M_ILLUM) return !(g->front && sampled);  // black to sampled rays: their light comes from the source
    if (g->type != M_MIRROR) return 0;
    uint m = s->modifiers[g->mod].flags;
    if ((m & MF_HAS_ALTERNATE) == 0u) return 0;
    if ((par->flags & PF_IRRADIANCE) != 0u && !sampled && (flags & PC_BENT) == 0u) return 0;  // white
    return !(g->front && sampled && (m & MF_ALTERNATE_PASSES) == 0u);
}

// The same for a shadow ray to the source of record q.  relayed: q is a virtual source and this surface is its relay.
FN int alternate_acts_for_shadow(TABLES(const SceneTables) s, PRIVATE(const Surface) g, GLOBAL const Source* src,
                                 int relayed) {
    if (g->type == M_ILLUM) {  // light of other illums and of glows ends at its front, which emits in place of it
        uint kind = src->light_type;
        return !(g->front && (kind == M_ILLUM || kind == M_GLOW) && src->relay == NONE);
    }

    return g->type == M_MIRROR && !relayed && (s->modifiers[g->mod].flags & MF_HAS_ALTERNATE) != 0u;
}

// Replaces the material by its alternate, and that by its own.  Returns 1 if the ray passes.
FN int take_alternate(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g, uint flags,
                      PRIVATE(Sampler) rnd) {
    while (alternate_acts(s, par, g, flags))
        if (!become_alternate(s, par, g, rnd)) return 1;
    return 0;
}

FN int shadow_alternate(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(Surface) g,
                        GLOBAL const Source* src, int relayed, PRIVATE(Sampler) rnd) {
    while (alternate_acts_for_shadow(s, g, src, relayed))
        if (!become_alternate(s, par, g, rnd)) return 1;
    return 0;
}
#endif
