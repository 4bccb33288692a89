// SPDX-License-Identifier: BSD-3-Clause
// Paths, in stages that run over queues (wavefront, Laine et al. 2013): generate and extend
// (integrator/begin.h), shade (here), shadow (integrator/shadow.h).  Frame 0 keeps the direct class, frames k >= 1 the
// diffuse one and, past the first m, both (paper section 7).
#ifndef LUX_PATH_H
#define LUX_PATH_H
#include "kernels/integrator/begin.h"
#include "kernels/integrator/image.h"
#include "kernels/integrator/emission.h"
#include "kernels/integrator/vertex.h"
#include "kernels/integrator/suffix.h"
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
#include "kernels/integrator/hours.h"
#include "kernels/integrator/miss.h"
#include "kernels/integrator/splat.h"

// Where paths are recorded (device/recorded_paths.cpp) this is a call; elsewhere nothing.  lobe: null before one is
// sampled.
#ifndef RECORD_VERTEX
#define RECORD_VERTEX(paths, vertex, kind, lobe)
#endif

// Shades the hit of a path.  Returns PATH_CONTINUES and PATH_SHADOW, as bits.
FN int path_shade(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    Vertex vertex;
    LobeSample lobe;
    vertex_load(par, paths, path, &vertex);

    // No hit: the path adds the sky and ends.
    if (vertex.hit.prim == NO_HIT) {
        if (HAS(SKY)) path_miss(s, par, paths, &vertex);
        return 0;
    }

    // Evaluate the hit: a null surface, an emitter, or a surface that scatters light; or the sensor where it begins.
    int on_sensor = vertex.hit.prim == ON_SENSOR;
    if (!on_sensor && !vertex_arrive(s, &vertex)) return 0;
    sampler_ahead(&vertex.rnd);
    int kind = on_sensor ? vertex_sensor(&vertex) : vertex_hit(s, par, paths, &vertex);

    // Path reuse: this hit may be the suffix vertex of the path.
    if ((vertex.flags & PC_RECORDS_SUFFIX) != 0u) path_record_suffix(s, paths, &vertex, kind);

    // The medium just crossed attenuates the path and may scatter light into it.
    int shadow = path_media(s, par, paths, &vertex);
    RECORD_VERTEX(paths, &vertex, kind, 0);

    // Emitter: the path adds its radiance and ends.
    if (kind == HIT_EMITTER) {
        path_hit_emitter(paths, &vertex);
        return shadow;
    }

    // Null surface: the ray passes through.
    if (kind == HIT_NULL) {
        path_pass(paths, &vertex);
        return shadow | PATH_CONTINUES;
    }

    // Direct light: sends a shadow ray to an active source.
    shadow |= path_direct(s, par, paths, &vertex);

    // Indirect light: a constant where -ab ends, else a sampled direction.
    path_ambient_value(par, &vertex);
    if (!sample_lobe(s, par, paths, &vertex, &lobe)) {
        vertex_store(paths, &vertex, vertex.path_length_start);
        return shadow;
    }
    RECORD_VERTEX(paths, &vertex, kind, &lobe);

    // A pilot path ends where a diffuse bounce would begin.
    if (par->mode == MODE_PILOT && lobe_is_diffuse(&lobe)) {
        path_end_pilot(paths, &vertex, &lobe);
        return shadow;
    }

    // What lights a suffix vertex in many hours may be gathered there later.
    if (ends_in_gather(par, &vertex, &lobe)) {
        path_end_in_gather(paths, &vertex, &lobe);
        return shadow;
    }

    // Continues along that direction, unless a limit or Russian roulette ends the path.
    return shadow | path_continue(par, paths, &vertex, &lobe);
}

// Paths without a hit, for devices where path_shade does not handle them (HAS(SKY)).
FN void path_sky(TABLES(const SceneTables) s, PARAMS(const Params) par, TABLES(const Paths) paths, uint path) {
    if (path_hit_prim(paths, path) != NO_HIT) return;
    Vertex vertex;
    vertex_load(par, paths, path, &vertex);
    path_miss(s, par, paths, &vertex);
}
#endif
