// SPDX-License-Identifier: BSD-3-Clause
// Order of coinciding surfaces.  As in RADIANCE, an opaque type precedes a transparent type, then one that faces the
// ray precedes others, then the modifier that is defined later.  Surfaces coincide if their distance along the normal
// of the first hit is within half of their rounding (Surface.rounding) and they are parallel there: a wall and a floor
// are not one surface at their common edge.  So the result depends on the ray alone, not on the order of hits in the
// tree.  A ray that leaves a surface starts twice as far from it (offset_ray.h), and does not hit surfaces that
// coincide with it.
#ifndef LUX_COINCIDE_H
#define LUX_COINCIDE_H

#define COINCIDE_COSINE 0.99f  // between normals
#define COINCIDE_SHARE 0.5f    // of the rounding
#define COINCIDE_BEHIND 64.0f  // surfaces much larger than the first one are hit this much farther behind it
#define COINCIDE_MOST 8u       // hits examined

// Returns 1 if the modifier is of a transparent type.
FN int is_clear(TABLES(const SceneTables) s, PRIVATE(const Surface) g) {
    if (in_instance(g->inst)) {
        GLOBAL const Instance* record = &s->instances[g->inst];
        if (record->mod != NONE) return record->clear != 0u;
    }
    return (s->prims[g->prim].kind & PRIM_CLEAR) != 0u;
}

FN uint coincide_rank(TABLES(const SceneTables) s, PRIVATE(const Surface) g) {
    return (is_clear(s, g) ? 0u : 2u) + (g->front ? 1u : 0u);
}

// Visible surface at a ray's first hit, among those whose class is in mask.  found: *look holds the first hit already.
FN void resolve_coincident_hits(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, int found,
                                PRIVATE(Look) look, PRIVATE(Hit) hit) {
    float3 normal = F3(0.0f, 0.0f, 0.0f), place = F3(0.0f, 0.0f, 0.0f);  // of the first
    float within = 0.0f, limit = 0.0f;
    uint rank = 0u, mod = 0u;  // of the best
    for (uint i = 0u; i < COINCIDE_MOST; i++) {
        if (i > 0u || !found) trace_next(s, ray, mask, look);
        if (i == 0u) *hit = look->hit;
        if (look->hit.prim == NO_HIT || (i == 0u && !may_coincide(look))) return;

        Surface g;
        surface_at(s, ray, &look->hit, &g);
        float distance = COINCIDE_SHARE * g.rounding;
        uint own = coincide_rank(s, &g);
        if (i == 0u) {
            normal = g.ng;
            place = g.p;
            within = distance;
            float behind = COINCIDE_BEHIND * within / fabs_(dot3(ray->dir, normal));
            limit = MIN_(look->limit, look->hit.t + (behind + SURFACE_ROUNDING * look->hit.t));
            rank = own;
            mod = g.mod;
        } else if (fabs_(dot3(sub3(g.p, place), normal)) <= MAX_(within, distance) &&
                   fabs_(dot3(g.ng, normal)) >= COINCIDE_COSINE && (own > rank || (own == rank && g.mod > mod))) {
            *hit = look->hit;
            rank = own;
            mod = g.mod;
        }
        if (look->second >= limit) return;
        look_past(look, limit);
    }
}

FN void trace_closest(TABLES(const SceneTables) s, PRIVATE(const Ray) ray, uint mask, PRIVATE(Hit) hit) {
    Look look;
    look_along(ray, &look);
    resolve_coincident_hits(s, ray, mask, 0, &look, hit);
}

#endif
