// SPDX-License-Identifier: BSD-3-Clause
// State of the paths in flight, one slot each, and the flags that say what a path has been through.
// A path's class is "diffuse" once it has left a surface into the hemisphere (paper section 3; spec shading 0.2).
#ifndef LUX_PATHS_H
#define LUX_PATHS_H

typedef struct {
    GLOBAL float4* org;   // xyz
    GLOBAL float4* dir;   // xyz, tmax
    GLOBAL float4* thr;   // rgb throughput, w = RADIANCE's ray weight (for -lw)
    GLOBAL float4* rad;   // rgb radiance gathered, w = path length from the eye
    GLOBAL uint4* info;   // flags, sampler key, index | dim << 8, instance
    GLOBAL float4* hit;   // t, prim (bits), u, v
    GLOBAL float4* sorg;  // shadow ray: origin, w = source index (bits)
    GLOBAL float4* sdir;  // direction, w = distance
    GLOBAL float4* scol;  // rgb of the contribution if unblocked
    // the medium the ray travels in (used if Params.medium.w; medium.h)
    GLOBAL float4* med;  // rgb extinction, w = sets of lights (bits)
    GLOBAL float4* alb;  // rgb albedo, w = eccentricity
    // the same for the shadow ray
    GLOBAL float4* smed;  // rgb extinction, w = antimatter (bits; clip.h)
    GLOBAL float4* salb;  // rgb albedo, w = sets of lights (bits)
} Paths;

// flags in info.x
#define PC_DIFFUSE 1u      // some ancestor was a hemisphere sample
#define PC_ROUGH 2u        // some ancestor was a rough-specular sample
#define PC_BENT 4u         // some reflection or refraction lies behind: not the eye's straight ray
#define PC_LEVEL_SHIFT 8u  // reflection level, 8 bits
#define PC_AB_SHIFT 16u    // diffuse depth, 8 bits
#define PC_STEP_SHIFT 24u  // surfaces met, 8 bits, saturating
#define PC_STEP_LIMIT 250u
#define RR_START 0.05f  // ray weight below which roulette sets in

FN float4 pack4(float3 v, float w) {
    float4 r;
    r.x = v.x;
    r.y = v.y;
    r.z = v.z;
    r.w = w;
    return r;
}
FN float3 xyz4(float4 v) { return F3(v.x, v.y, v.z); }

FN Sampler path_sampler(uint4 info) {
    Sampler s;
    s.key = info.y;
    s.index = info.z & 255u;
    s.dim = info.z >> 8;
    return s;
}
#endif
