// SPDX-License-Identifier: BSD-3-Clause
// prism1, prism2: a panel that redirects light by functions (spec: RADIANCE shading 3.18).
// values: coefficient and direction of exit 1, of exit 2.
#ifndef LUX_MAT_PRISM_H
#define LUX_MAT_PRISM_H

// Rays that are not aimed at a virtual source of the panel: exit 1 (and 2), the sum of both.
FN void mat_prism(uint flags, PRIVATE(const float) value, PRIVATE(Lobes) lobes) {
    float3 d = F3(value[1], value[2], value[3]);
    if (value[0] > 0.0f && length3(d) > 1e-6f) {
        lobes->through = F3(value[0], value[0], value[0]);
        lobes->through_dir = unit3(d);
    }

    if ((flags & MF_TWO_EXITS) == 0u) return;
    d = F3(value[5], value[6], value[7]);
    if (value[4] > 0.0f && length3(d) > 1e-6f) {
        lobes->refract = F3(value[4], value[4], value[4]);
        lobes->refract_dir = unit3(d);
    }
}

// A shadow ray aimed at the virtual source of one exit; aim: unit direction to the next source behind the panel.
FN float prism_exit(TABLES(const SceneTables) s, PARAMS(const Params) par, PRIVATE(const Surface) g, float3 aim,
                    uint exit, PRIVATE(float3) dir) {
    float vars[CAL_VARS], value[CAL_OUTPUTS];
    GLOBAL const Modifier* m = &s->modifiers[g->mod];
    material_vars(par, g, vars);
    vars[CAL_DXA] = aim.x;
    vars[CAL_DYA] = aim.y;
    vars[CAL_DZA] = aim.z;
    vars_to_frame(s, g, vars);
    if (cal_run(s, m->program, vars, value)) return 0.0f;
    values_from_frame(s, g, m->flags, value);
    uint k = 4u * exit;
    float3 d = F3(value[k + 1u], value[k + 2u], value[k + 3u]);
    if (value[k] <= 0.0f || length3(d) <= 1e-6f) return 0.0f;
    *dir = unit3(d);
    return value[k];
}
#endif
