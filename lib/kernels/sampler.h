// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by counter: (seed, pixel, sample index, dimension) -> [0,1)^2, the same on every device and in any
// order. Owen-scrambled Sobol points in pairs (Burley 2020, "Practical Hash-based Owen Scrambling"), sample index =
// frame; a fresh scramble every 64 frames, so that blocks of frames are independent and give honest error intervals.
#ifndef LUX_SAMPLER_H
#define LUX_SAMPLER_H

#define SAMPLER_BLOCK_BITS 6u

typedef struct {
    uint key, index, dim;
} Sampler;

FN uint hash32(uint x) {  // a 32-bit finaliser with low bias (Wellons' lowbias32 constants)
    x ^= x >> 16;
    x *= 0x7feb352du;
    x ^= x >> 15;
    x *= 0x846ca68bu;
    x ^= x >> 16;
    return x;
}

FN uint reverse_bits(uint v) {
    v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1);
    v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2);
    v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4);
    v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8);
    return (v >> 16) | (v << 16);
}

// Hash-based Owen scramble of a bit-reversed integer (Laine-Karras style permutation, Burley's constants by Vegdahl).
FN uint owen_reversed(uint x, uint seed) {
    x ^= x * 0x3d20adeau;
    x += seed;
    x *= (seed >> 16) | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return x;
}

FN uint sobol_second(
    uint i) {  // second Sobol dimension of index i, lowest bit first: the Pascal triangle mod 2, without tables
    uint v = i;
    v ^= v >> 16;
    v ^= (v & 0xff00ff00u) >> 8;
    v ^= (v & 0xf0f0f0f0u) >> 4;
    v ^= (v & 0xccccccccu) >> 2;
    v ^= (v & 0xaaaaaaaau) >> 1;
    return v;
}

FN Sampler sampler_start(uint seed_lo, uint seed_hi, uint pixel, uint index, uint stream) {
    Sampler rnd;
    uint block = index >> SAMPLER_BLOCK_BITS;
    rnd.key = hash32(pixel ^ hash32(block ^ hash32(seed_lo ^ hash32(seed_hi ^ hash32(stream + 0x9e3779b9u)))));
    rnd.index = index & ((1u << SAMPLER_BLOCK_BITS) - 1u);
    rnd.dim = 0u;
    return rnd;
}

FN float unit_float(uint x) { return (float)(x >> 8) * (1.0f / 16777216.0f); }

// The next pair of dimensions.
FN float2 sample2(PRIVATE Sampler* rnd) {
    uint d = rnd->dim++;
    uint k = hash32(rnd->key + d * 0x9e3779b9u);
    uint shuffled = reverse_bits(owen_reversed(reverse_bits(rnd->index), k));  // Owen-shuffled index
    uint x = reverse_bits(owen_reversed(shuffled, hash32(k ^ 0xa511e9b3u)));
    uint y = reverse_bits(owen_reversed(sobol_second(shuffled), hash32(k ^ 0x63d83595u)));
    float2 r;
    r.x = unit_float(x);
    r.y = unit_float(y);
    return r;
}

FN float sample1(PRIVATE Sampler* rnd) {
    float2 r = sample2(rnd);
    return r.x;
}
#endif
