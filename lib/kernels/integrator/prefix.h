// SPDX-License-Identifier: BSD-3-Clause
// Records the prefix vertex and the state of a path with respect to its suffix vertex (suffix.h).
#ifndef LUX_PATH_PREFIX_H
#define LUX_PATH_PREFIX_H

// Returns 1 if a diffuse ray leaves the first surface that the eye sees directly or through panes.  The vertex holds
// the flags of the path after this step.
FN int is_prefix_vertex(PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    uint flags = vertex->flags;
    if (lobe->type != SAMPLE_DIFFUSE_R || path_bounces(flags) != 1u || path_level(flags) != 1u) return 0;
    if ((flags & (PC_ROUGH | PC_BENT)) != 0u) return 0;
    if ((vertex->lobes.flags & (LOBE_BSDF | LOBE_OWN_NORMALS)) != 0u) return 0;
    return !vertex->absorbs || (!(max3(vertex->arriving.k) > 0.0f) && vertex->arriving.lights == 0u);
}

FN void path_record_prefix(TABLES(const Paths) paths, PRIVATE(Vertex) vertex, PRIVATE(const LobeSample) lobe) {
    PRIVATE(const Surface) g = &vertex->g;
    uint path = vertex->path;

    // behind a suffix vertex the path's light goes to the group if the suffix vertex scatters it diffusely, else to the
    // path alone
    if (vertex->at_suffix && lobe_is_diffuse(lobe)) {
        vertex->throughput = F3(1.0f, 1.0f, 1.0f);
        vertex->flags |= PC_SUFFIX;
    }

    // a reflection in a pane is not the eye's straight ray
    if (lobe->type != SAMPLE_THROUGH) vertex->flags &= ~PC_RECORDS_SUFFIX;

    if (!is_prefix_vertex(vertex, lobe)) return;
    float rarity = lobe->total / MAX_(lobe->prob, 1e-30f);
    write4_(paths->prefix_p, path, prefix_p_words(offset_ray(g->p, g->ng, g->rounding), 0u));
    write4_(paths->prefix_n, path, prefix_n_words(g->n, MAX_(lobe->weight, 0.0f)));
    write4_(paths->prefix_ng, path, prefix_ng_words(g->ng, 0u));
    paths->mixture[path] = lobe->mixture;
    write4_(paths->prefix_throughput, path,
            prefix_throughput_words(scale3(mul3(vertex->throughput, lobe->color), rarity), 0.0f));
    vertex->flags |= PC_RECORDS_SUFFIX;
}
#endif
