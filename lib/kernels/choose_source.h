// SPDX-License-Identifier: BSD-3-Clause
// Which active source a shadow ray is sent to: each with a chance proportional to what it promises at the point (power,
// solid angle, cosines, the gates that a virtual one's light must pass); all of them looked at, or of very many some
// drawn by power (resampled importance sampling, Talbot et al. 2005).  A promise is 0 only where the source can give
// nothing, so the estimate is right in the mean whatever the promises are.
#ifndef LUX_CHOOSE_SOURCE_H
#define LUX_CHOOSE_SOURCE_H

#define SOURCES_LOOKED_AT 256u  // no more than so many are all looked at
#define SOURCE_CANDIDATES 32u   // else so many are drawn
#define LEAST_COSINE 0.05f      // what lies behind a surface or on edge may still shine through it or at its rim

// May light from a source about p + to reach p through gate q?  reach: the sine of half the angle that the source
// subtends.  Gates stand where the relays of a virtual source seem to be from p.
FN int gate_passes(GLOBAL const float* gate, float3 p, float3 to, float reach) {
    float3 c = sub3(f3_at(gate + GATE_CENTRE), p), n = f3_at(gate + GATE_NORMAL);
    float3 u = f3_at(gate + GATE_U), v = f3_at(gate + GATE_V);
    float down = dot3(n, to), d2 = dot3(to, to);
    if (down * down < 4.0f * reach * reach * d2) return 1;  // too much on edge to tell
    float along = dot3(n, c) / down;
    if (along < -1e-3f || (down > 0.0f && gate[GATE_BOTH_SIDES] == 0.0f)) return 0;  // behind p; its back
    float3 off = sub3(scale3(to, along), c);
    float wide = 3.0f * reach * fabs_(along) * d2 / fabs_(down);  // no less than the source's cone on the gate's plane
    return fabs_(dot3(off, u)) <= 1.001f + wide * length3(u) && fabs_(dot3(off, v)) <= 1.001f + wide * length3(v);
}

// What source i could give a surface at p with normal n, up to a factor; both: from behind, too.
FN float source_promise(PRIVATE const SceneTables* s, UNIFORM const Params* par, uint i, float3 p, float3 n, int both) {
    GLOBAL const float* src = source_record(s, par, i);
    uint kind = as_uint_(src[SRC_KIND]), relay = as_uint_(src[SRC_VIRTUAL]);
    float3 to = f3_at(src + SRC_CENTRE);
    float r = src[SRC_RADIUS], power = src[SRC_POWER] * src[SRC_AREA], d2 = 1.0f, d = 1.0f;
    if (kind == SK_CYLINDER) r += length3(f3_at(src + SRC_U));
    if (src[SRC_SHEARED] != 0.0f)  // no less than any sampled point is away
        r = 2.0f * (length3(f3_at(src + SRC_U)) + length3(f3_at(src + SRC_V)) + length3(f3_at(src + SRC_NORMAL)));

    if (kind != SK_DISTANT) {
        to = sub3(to, p);
        d2 = dot3(to, to);
        d = sqrt_(d2);
        if (src[SRC_MAXRAD] > 0.0f && d > src[SRC_MAXRAD] + r) return 0.0f;
        power /= MAX_(d2, 0.25f * r * r);
    }

    float reach = r / MAX_(d, 1e-9f);  // sine of its half angle
    if (relay != NONE) {
        uint count = s->u[relay + RELAY_GATES];
        GLOBAL const float* gate = s->f + s->u[relay + RELAY_GATES_AT];
        for (uint k = 0u; k < count; k++, gate += GATE_FLOATS)
            if (!gate_passes(gate, p, to, reach)) return 0.0f;
    }

    if (kind == SK_PARALLELOGRAM || kind == SK_POLYGON || kind == SK_RING) {
        float c = -dot3(to, f3_at(src + SRC_NORMAL));
        if (c <= 0.0f) return 0.0f;
        power *= MIN_(c / MAX_(d, 1e-9f) + reach, 1.0f);
    }

    float c = dot3(to, n) / MAX_(d, 1e-9f);
    c = (both ? fabs_(c) : c) + reach;
    return power * MIN_(MAX_(c, 0.0f) + LEAST_COSINE, 1.0f);
}

// Candidate j of `count`: its source, by the cumulative power table, and its weight.
FN float source_candidate(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, int both, uint j,
                          uint count, float x, PRIVATE uint* source) {
    GLOBAL const float* cdf = s->f + par->cdf_at;
    float y = ((float)j + x) / (float)count;
    uint lo = 0u, hi = par->source_count - 1u;

    while (lo < hi) {
        uint mid = (lo + hi) / 2u;
        if (cdf[mid] > y) hi = mid;
        else lo = mid + 1u;
    }

    *source = lo;
    float pdf = cdf[lo] - (lo > 0u ? cdf[lo - 1u] : 0.0f);
    return source_promise(s, par, lo, p, n, both) / (pdf * (float)count);
}

// Chooses one active source for a surface at p with normal n, lit from both sides or not.  Returns 1/probability, or 0
// if none can shine.
FN float choose_source(PRIVATE const SceneTables* s, UNIFORM const Params* par, float3 p, float3 n, int both,
                       PRIVATE Sampler* rnd, PRIVATE uint* chosen) {
    uint count = par->source_count, picked = 0u, all = count <= SOURCES_LOOKED_AT;
    if (count == 0u) return 0.0f;
    if (count == 1u) {
        *chosen = 0u;
        return 1.0f;
    }

    float2 x = sample2(rnd);
    float sum = 0.0f, kept = 0.0f, r = x.x;
    if (!all) count = SOURCE_CANDIDATES;

    for (uint j = 0u; j < count; j++) {
        uint i = j;
        float w = all ? source_promise(s, par, i, p, n, both) : source_candidate(s, par, p, n, both, j, count, x.y, &i);
        if (w <= 0.0f) continue;
        sum += w;
        float t = w / sum;  // one random number, reused (Chao's reservoir)
        if (r < t) {
            picked = i;
            kept = w;
            r = r / t;
        } else {
            r = (r - t) / (1.0f - t);
        }
    }

    if (sum <= 0.0f) return 0.0f;
    *chosen = picked;
    return sum / kept * (all ? 1.0f : kept / source_promise(s, par, picked, p, n, both));
}
#endif
