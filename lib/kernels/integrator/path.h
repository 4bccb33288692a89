// SPDX-License-Identifier: BSD-3-Clause
// Paths, in stages that run over queues (wavefront, Laine et al. 2013): generate and extend
// (integrator/begin.h), shade (here), shadow (integrator/shadow.h).  Frame 0 keeps the direct class, frames k >= 1 the
// diffuse one and, past the first m, both (paper section 7).
#ifndef LUX_PATH_H
#define LUX_PATH_H
#include "kernels/integrator/emission.h"
#include "kernels/integrator/begin.h"
#include "kernels/integrator/vertex.h"
#include "kernels/integrator/suffix.h"
#include "kernels/integrator/miss.h"
#include "kernels/integrator/hit.h"
#include "kernels/integrator/scatter.h"
#include "kernels/integrator/media.h"
#include "kernels/integrator/direct.h"
#include "kernels/integrator/sample_bsdf.h"
#include "kernels/integrator/prefix.h"
#include "kernels/integrator/continue.h"
#include "kernels/integrator/pilot.h"
#include "kernels/integrator/shadow.h"
#include "kernels/integrator/connect.h"
#include "kernels/integrator/splat.h"

// Shades the hit of a path.  Returns bits: PATH_CONTINUES, PATH_SHADOW.
FN int path_shade(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    Vertex vertex;
    LobeSample lobe;
    vertex_load(par, paths, path, &vertex);

    // The ray has met nothing: what it sees is the sky, and the path ends.
    if (vertex.hit.prim == NO_HIT) {
        if (HAS(SKY)) path_miss(s, par, paths, &vertex);
        return 0;
    }

    // It has met a surface.  What is it: a hole, an emitter, something that scatters light?
    if (!vertex_arrive(s, &vertex)) return 0;
    sampler_ahead(&vertex.rnd);
    int met = vertex_hit(s, par, paths, &vertex);

    // It may be the suffix vertex that the path seeks for all its group.
    if ((vertex.flags & PC_RECORDS_SUFFIX) != 0u) path_record_suffix(s, par, paths, &vertex, met);

    // What lies between has dimmed the path and may have scattered light into it.
    int shadow = path_media(s, par, paths, &vertex);

    // An emitter gives its radiance, and the path ends.
    if (met == HIT_EMITTER) {
        path_hit_emitter(paths, &vertex);
        return shadow;
    }

    // Where nothing shows the ray goes straight on.
    if (met == HIT_NULL) {
        path_pass(paths, &vertex);
        return shadow | PATH_CONTINUES;
    }

    // Light that comes straight from an active source: a shadow ray is to find out.
    shadow |= path_direct(s, par, paths, &vertex);

    // Light that comes over other surfaces: where -ab ends a constant, else what one way on will find.
    path_ambient_value(par, &vertex);
    if (!sample_lobe(s, par, &vertex, &lobe)) {
        vertex_store(paths, &vertex, vertex.path_length_start);
        return shadow;
    }

    // A walk that only learns ends where a bounce would begin.
    if (par->mode == MODE_PILOT && lobe_is_diffuse(&lobe)) {
        path_end_pilot(paths, &vertex, &lobe);
        return shadow;
    }

    // The path takes that way, unless a limit or roulette ends it.
    return shadow | path_continue(par, paths, &vertex, &lobe);
}

// A path that has met nothing, where the above does not see to it (HAS(SKY)).
FN void path_sky(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    if (as_uint_(paths->hit[path].y) != NO_HIT) return;
    Vertex vertex;
    vertex_load(par, paths, path, &vertex);
    path_miss(s, par, paths, &vertex);
}
#endif
