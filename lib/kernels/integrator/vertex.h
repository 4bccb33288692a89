// SPDX-License-Identifier: BSD-3-Clause
// A vertex: state of one step of a path at its hit.  Each stage (the other files of this folder) reads the results of
// the stages before it and adds its own.
#ifndef LUX_PATH_VERTEX_H
#define LUX_PATH_VERTEX_H

STRUCT(Vertex) {
    // the path so far
    uint path;                // its index in Paths
    uint flags;               // PC_ flags
    int wanted;               // does this pass record light of the path's class? (emission.h)
    float3 rad;               // radiance gathered
    float3 throughput;        // throughput
    float weight;             // RADIANCE's ray weight: product of the surfaces' coefficients, not of 1/probabilities
    float path_length_start;  // path length from the eye to where the last ray began
    Sampler rnd;

    // the suffix vertex, if this is one (suffix.h)
    int at_suffix;
    float3 suffix_rad;  // its outgoing radiance

    // the ray, and the surface that it hit
    Ray ray;
    Hit hit;
    Surface g;
    float3 emitted;  // if the surface is an emitter
    Lobes lobes;     // if it scatters

    // media (medium.h) and antimatter (clip.h) on both sides of the surface
    int absorbs;           // is there any medium in the scene?
    Medium arriving;       // of the segment that ends here, as corrected by the surface
    Medium medium_behind;  // behind the surface
    uint clip_before;      // antimatter state on the ray's side
    uint clip_behind;      // and behind the surface
    uint scatterers;       // number of sources that the crossed medium scatters
    int went_to_medium;    // this step's shadow ray starts in the medium, not at the surface
};

// Result bits of path_shade.
#define PATH_CONTINUES 1  // the path holds the next ray
#define PATH_SHADOW 2     // and a shadow ray

// Kinds of hits.
#define HIT_NULL 0     // the ray passes
#define HIT_EMITTER 1  // the path ends
#define HIT_SURFACE 2  // lobes hold the scattering

FN void vertex_load(PARAMS(const Params) par, TABLES(const Paths) paths, uint path, PRIVATE(Vertex) vertex) {
    Row_org org = org_of(read4_(paths->org, path));
    Row_dir dir = dir_of(read4_(paths->dir, path));
    Row_throughput throughput = throughput_of(read4_(paths->throughput, path));
    Row_rad rad = rad_of(read4_(paths->rad, path));
    PathInfo info = info_of(read4_(paths->info, path));
    if ((info.flags & PC_SUFFIX) != 0u) rad = rad_of(read4_(paths->suffix_rad, path));

    vertex->path = path;
    vertex->flags = info.flags;
    vertex->rnd = path_sampler(info);
    vertex->rad = rad.rgb;
    vertex->path_length_start = rad.path_length;
    vertex->throughput = throughput.rgb;
    vertex->weight = throughput.weight;
    vertex->wanted = class_wanted(par, info.flags, path_sample_index(par, path));

    vertex->at_suffix = 0;
    vertex->suffix_rad = F3(0.0f, 0.0f, 0.0f);

    vertex->ray.org = org.point;
    vertex->ray.dir = dir.way;
    vertex->ray.tmin = 0.0f;
    vertex->ray.tmax = dir.length;
    vertex->hit = path_hit(read4_(paths->hit, path), info);

    vertex->absorbs = has_media(par);
    vertex->arriving = vertex->absorbs ? path_medium(paths, path) : medium_open(par);
    vertex->medium_behind = vertex->arriving;
    vertex->clip_before = org.clip;
    vertex->clip_behind = vertex->clip_before;
    vertex->scatterers = 0u;
    vertex->went_to_medium = 0;
}

// Stores the radiance of the path, for itself or for its suffix vertex.  length: as below.
FN void vertex_store_rad(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, float length) {
    uint path = vertex->path;
    if (vertex->at_suffix) write4_(paths->suffix_rad, path, suffix_rad_words(vertex->suffix_rad, length));
    if (vertex->at_suffix || (vertex->flags & PC_SUFFIX) == 0u)
        write4_(paths->rad, path, rad_words(vertex->rad, length));
    else write4_(paths->suffix_rad, path, suffix_rad_words(vertex->rad, length));
}

// Stores the state of the path that the step has changed.  length: from the eye to the origin of its next ray.
FN void vertex_store(TABLES(const Paths) paths, PRIVATE(const Vertex) vertex, float length) {
    vertex_store_rad(paths, vertex, length);
    write4_(paths->info, vertex->path, info_words(vertex->flags, &vertex->rnd, vertex->hit.inst));
}

FN void vertex_add(PRIVATE(Vertex) vertex, float3 radiance) {
    vertex->rad = add3(vertex->rad, mul3(vertex->throughput, radiance));
}
#endif
