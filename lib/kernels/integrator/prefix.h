// SPDX-License-Identifier: BSD-3-Clause
// What the way taken from a surface means for the ends that paths share (suffix.h).
#ifndef LUX_PATH_PREFIX_H
#define LUX_PATH_PREFIX_H

// Does a diffuse ray leave the first surface that the eye's straight ray meets, or that behind panes, into the open?
// The flags of the vertex are those that the path has from here on.
FN int is_prefix_vertex(PRIVATE(const Vertex) vertex, PRIVATE(const LobeSample) way) {
    uint flags = vertex->flags, level = (vertex->flags >> PC_LEVEL_SHIFT) & 255u;
    uint bounces = (vertex->flags >> PC_AB_SHIFT) & 255u;
    if (way->way != SAMPLE_DIFFUSE_R || bounces != 1u || level != 1u || (flags & (PC_ROUGH | PC_BENT)) != 0u) return 0;
    if ((vertex->lobes.flags & (LOBE_BSDF | LOBE_OWN_NORMALS)) != 0u) return 0;
    return !vertex->absorbs || (!(max3(vertex->arriving.k) > 0.0f) && vertex->arriving.lights == 0u);
}

FN void path_ends(TABLES(const Paths) paths, PRIVATE(Vertex) vertex, PRIVATE(const LobeSample) way) {
    PRIVATE(const Surface) g = &vertex->g;
    uint slot = vertex->slot;

    // behind a suffix vertex the path gathers for it if what it finds is scattered evenly there, else for itself
    if (vertex->at_suffix && lobe_is_diffuse(way)) {
        vertex->thr = F3(1.0f, 1.0f, 1.0f);
        vertex->flags |= PC_SUFFIX;
    }

    // what a pane mirrors is not seen straight
    if (way->way != SAMPLE_THROUGH) vertex->flags &= ~PC_RECORDS_SUFFIX;

    if (!is_prefix_vertex(vertex, way)) return;
    float rarity = way->sum / MAX_(way->chance, 1e-30f);
    write4_(paths->prefix_p, slot, pack4(offset_ray(g->p, g->ng, g->reach), way->aims.light));
    write4_(paths->prefix_n, slot, pack4(g->n, MAX_(way->factor, 0.0f)));
    write4_(paths->prefix_ng, slot, pack4(g->ng, as_float_(way->aims.highlights)));
    write4_(paths->prefix_thr, slot, pack4(scale3(mul3(vertex->thr, way->color), rarity), 0.0f));
    vertex->flags |= PC_RECORDS_SUFFIX;
}
#endif
