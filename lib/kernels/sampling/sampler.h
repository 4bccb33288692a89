// SPDX-License-Identifier: BSD-3-Clause
// Random numbers by counter: (seed, pixel, sample index, dimension) -> [0,1)^2, the same on every device and in any
// order. Owen-scrambled Sobol points in pairs (Burley 2020, "Practical Hash-based Owen Scrambling"), sample index =
// frame; a fresh scramble every 64 frames, so that blocks of frames are independent and give honest error intervals.
#ifndef LUX_SAMPLER_H
#define LUX_SAMPLER_H

#define SAMPLER_BLOCK_BITS 6u

#define SAMPLER_AHEAD 4u

STRUCT(Sampler) {
    uint key, index, dim;
    uint until;  // pairs below this dimension are drawn: the SAMPLER_AHEAD before it
#if WIDE_WORDS
    float drawn[2u * SAMPLER_AHEAD];  // first numbers, second numbers
#endif
};

// The steps from a counter to a random number, for one WORD or the eight of a wide one: the same text, hence the same
// numbers.
//   hash          a 32-bit finaliser with low bias (Wellons' lowbias32 constants)
//   reverse       bit 0 becomes bit 31
//   owen          hash-based Owen scramble of a bit-reversed integer (Laine-Karras style permutation, Burley's
//                 constants by Vegdahl)
//   sobol_second  second Sobol dimension of index v, lowest bit first: the Pascal triangle mod 2, without tables
#define SAMPLER_STEPS(WORD, hash, reverse, owen, sobol_second)   \
    FN WORD hash(WORD x) {                                       \
        x ^= x >> 16;                                            \
        x *= 0x7feb352du;                                        \
        x ^= x >> 15;                                            \
        x *= 0x846ca68bu;                                        \
        x ^= x >> 16;                                            \
        return x;                                                \
    }                                                            \
    FN WORD reverse(WORD v) {                                    \
        v = ((v >> 1) & 0x55555555u) | ((v & 0x55555555u) << 1); \
        v = ((v >> 2) & 0x33333333u) | ((v & 0x33333333u) << 2); \
        v = ((v >> 4) & 0x0f0f0f0fu) | ((v & 0x0f0f0f0fu) << 4); \
        v = ((v >> 8) & 0x00ff00ffu) | ((v & 0x00ff00ffu) << 8); \
        return (v >> 16) | (v << 16);                            \
    }                                                            \
    FN WORD owen(WORD x, WORD seed) {                            \
        x ^= x * 0x3d20adeau;                                    \
        x += seed;                                               \
        x *= (seed >> 16) | 1u;                                  \
        x ^= x * 0x05526c56u;                                    \
        x ^= x * 0x53a22864u;                                    \
        return x;                                                \
    }                                                            \
    FN WORD sobol_second(WORD v) {                               \
        v ^= v >> 16;                                            \
        v ^= (v & 0xff00ff00u) >> 8;                             \
        v ^= (v & 0xf0f0f0f0u) >> 4;                             \
        v ^= (v & 0xccccccccu) >> 2;                             \
        v ^= (v & 0xaaaaaaaau) >> 1;                             \
        return v;                                                \
    }

SAMPLER_STEPS(uint, hash32, reverse_bits, owen_reversed, sobol_second)
#if WIDE_WORDS
SAMPLER_STEPS(v8u, hash8, reverse_bits8, owen_reversed8, sobol_second8)
#endif

#define SAMPLER_DIM 0x9e3779b9u    // from one dimension's hash to the next
#define SAMPLER_FIRST 0xa511e9b3u  // distinguishes the scrambles of a pair
#define SAMPLER_SECOND 0x63d83595u

FN Sampler sampler_start(uint seed_lo, uint seed_hi, uint pixel, uint index, uint stream) {
    Sampler rnd;
    uint block = index >> SAMPLER_BLOCK_BITS;
    rnd.key = hash32(pixel ^ hash32(block ^ hash32(seed_lo ^ hash32(seed_hi ^ hash32(stream + 0x9e3779b9u)))));
    rnd.index = index & ((1u << SAMPLER_BLOCK_BITS) - 1u);
    rnd.dim = 0u;
    rnd.until = 0u;
    return rnd;
}

FN float unit_float(uint x) { return (float)(x >> 8) * (1.0f / 16777216.0f); }

// Draws the next pairs together, where this costs no more than one (WIDE_WORDS): the first four lanes hold the first
// numbers, the others the second.
#if WIDE_WORDS
FN void sampler_ahead(PRIVATE(Sampler) rnd) {
    v8u second = second_half8_();
    v8u k = hash8(count4_(rnd->key + rnd->dim * SAMPLER_DIM, SAMPLER_DIM));
    v8u shuffled = reverse_bits8(owen_reversed8(splat8u_(reverse_bits(rnd->index)), k));
    v8u at = shuffled ^ ((shuffled ^ sobol_second8(shuffled)) & second);
    v8u scramble = hash8(k ^ (SAMPLER_FIRST ^ (second & (SAMPLER_FIRST ^ SAMPLER_SECOND))));
    v8u x = reverse_bits8(owen_reversed8(at, scramble));
    store8_(float8_(x >> 8) * (1.0f / 16777216.0f), rnd->drawn);
    rnd->until = rnd->dim + SAMPLER_AHEAD;
}
#else
FN void sampler_ahead(PRIVATE(Sampler) rnd) { rnd->until = 0u; }
#endif

// One pair alone.
FN float2 sampler_pair(PRIVATE(const Sampler) rnd, uint dim) {
    uint k = hash32(rnd->key + dim * SAMPLER_DIM);
    uint shuffled = reverse_bits(owen_reversed(reverse_bits(rnd->index), k));  // Owen-shuffled index
    float2 r;
    r.x = unit_float(reverse_bits(owen_reversed(shuffled, hash32(k ^ SAMPLER_FIRST))));
    r.y = unit_float(reverse_bits(owen_reversed(sobol_second(shuffled), hash32(k ^ SAMPLER_SECOND))));
    return r;
}

// The next pair of dimensions.
FN float2 sample2(PRIVATE(Sampler) rnd) {
    uint dim = rnd->dim++;
#if WIDE_WORDS
    if (dim < rnd->until) {
        uint k = dim + SAMPLER_AHEAD - rnd->until;
        float2 r;
        r.x = rnd->drawn[k];
        r.y = rnd->drawn[k + SAMPLER_AHEAD];
        return r;
    }
#endif
    return sampler_pair(rnd, dim);
}

FN float sample1(PRIVATE(Sampler) rnd) {
    float2 r = sample2(rnd);
    return r.x;
}
#endif
