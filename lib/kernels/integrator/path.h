// SPDX-License-Identifier: BSD-3-Clause
// One path per slot, in stages that run over queues (wavefront, Laine et al. 2013): generate and extend
// (integrator/begin.h), shade (here), shadow (integrator/shadow.h).  Frame 0 keeps the direct class, frames k >= 1 the
// diffuse one and, past the first m, both (paper section 7).
#ifndef LUX_PATH_H
#define LUX_PATH_H
#include "kernels/integrator/emission.h"
#include "kernels/integrator/begin.h"
#include "kernels/integrator/vertex.h"
#include "kernels/integrator/far.h"
#include "kernels/integrator/miss.h"
#include "kernels/integrator/meet.h"
#include "kernels/integrator/scatter.h"
#include "kernels/integrator/media.h"
#include "kernels/integrator/direct.h"
#include "kernels/integrator/ways.h"
#include "kernels/integrator/near.h"
#include "kernels/integrator/end.h"
#include "kernels/integrator/walk.h"
#include "kernels/integrator/shadow.h"
#include "kernels/integrator/connect.h"
#include "kernels/integrator/draw.h"

// Shades the hit of a slot.  Returns bits: PATH_GOES_ON, PATH_SHADOW.
FN int path_shade(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    Vertex vertex;
    Way way;
    vertex_load(par, paths, slot, &vertex);

    // The ray has met nothing: what it sees is the sky, and the path ends.
    if (vertex.hit.prim == NO_HIT) {
        if (HAS(SKY)) path_miss(s, par, paths, &vertex);
        return 0;
    }

    // It has met a surface.  What is it: a hole, a lamp, something that scatters light?
    if (!vertex_arrive(s, &vertex)) return 0;
    sampler_ahead(&vertex.rnd);
    int met = vertex_meet(s, par, paths, &vertex);

    // It may be the far end that the path seeks for all its group.
    if ((vertex.flags & PC_SEEKS) != 0u) path_seek(s, par, paths, &vertex, met);

    // What lies between has dimmed the path and may have scattered light into it.
    int shadow = path_media(s, par, paths, &vertex);

    // A lamp gives its radiance, and the path ends.
    if (met == MET_LAMP) {
        path_lamp(paths, &vertex);
        return shadow;
    }

    // Where nothing shows the ray goes straight on.
    if (met == MET_NOTHING) {
        path_pass(paths, &vertex);
        return shadow | PATH_GOES_ON;
    }

    // Light that comes straight from an active source: a shadow ray is to find out.
    shadow |= path_direct(s, par, paths, &vertex);

    // Light that comes over other surfaces: where -ab ends a constant, else what one way on will find.
    path_ambient_value(par, &vertex);
    if (!choose_way(s, par, &vertex, &way)) {
        vertex_store(paths, &vertex, vertex.before);
        return shadow;
    }

    // A walk that only learns ends where a bounce would begin.
    if (par->mode == MODE_WALK && way_bounces(&way)) {
        path_end_walk(paths, &vertex, &way);
        return shadow;
    }

    // The path takes that way, unless a limit or roulette ends it.
    return shadow | path_go_on(par, paths, &vertex, &way);
}

// A slot that has met nothing, where the above does not see to it (HAS(SKY)).
FN void path_sky(SHARED(const SceneTables) s, UNIFORM(const Params) par, SHARED(const Paths) paths, uint slot) {
    if (as_uint_(paths->hit[slot].y) != NO_HIT) return;
    Vertex vertex;
    vertex_load(par, paths, slot, &vertex);
    path_miss(s, par, paths, &vertex);
}
#endif
