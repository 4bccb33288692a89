// SPDX-License-Identifier: BSD-3-Clause
// Sine, cosine, tangent and their inverses, with the method and limits that math.h states.
#ifndef LUX_MATH_TRIG_H
#define LUX_MATH_TRIG_H

// 96 bits of 2/pi, the first of weight 2^(1-k): of m 2^k 2/pi mod 4 only these matter.
FN void k_two_over_pi(int k, PRIVATE(uint) w) {
    uint two_over_pi[8];
    two_over_pi[0] = 0u;
    two_over_pi[1] = 0xa2f9836eu;
    two_over_pi[2] = 0x4e441529u;
    two_over_pi[3] = 0xfc2757d1u;
    two_over_pi[4] = 0xf534ddc0u;
    two_over_pi[5] = 0xdb629599u;
    two_over_pi[6] = 0x3c439041u;
    two_over_pi[7] = 0xfe5163abu;

    // the window starts k + 30 bits after the top of the table (32 zero bits, then the fraction)
    uint word = (uint)(k + 30) >> 5, shift = (uint)(k + 30) & 31u;
    w[0] = two_over_pi[word];
    w[1] = two_over_pi[word + 1u];
    w[2] = two_over_pi[word + 2u];

    if (shift) {
        w[0] = (w[0] << shift) | (w[1] >> (32u - shift));
        w[1] = (w[1] << shift) | (w[2] >> (32u - shift));
        w[2] = (w[2] << shift) | (word + 3u < 8u ? two_over_pi[word + 3u] >> (32u - shift) : 0u);
    }
}

// The quarter turns in x and the rest in [-pi/4, pi/4], for |x| above 2^13: x = m 2^k times 192 bits of 2/pi.
FN float k_reduce_far(float x, PRIVATE(int) quadrant) {
    uint u = as_uint_(x);
    uint m = (u & 0x007fffffu) | 0x00800000u, shift, w[3];
    int k = (int)((u >> 23) & 255u) - 150, q;  // x = m 2^k, k >= -10
    ulong64 a, b, c;
    float hi, frac;
    k_two_over_pi(k, w);

    // 96-bit product, modulo 2^96 = modulo 4: its top two bits are the quadrant.
    a = (ulong64)w[0] * m;
    b = (ulong64)w[1] * m;
    c = (ulong64)w[2] * m;
    b += c >> 32;
    a = ((a & 0xffffffffu) << 32) + b;
    q = (int)(a >> 62);
    a <<= 2;  // fraction of a quarter turn, 64 bits

    if (a >> 63) {  // nearest quadrant
        q = q + 1;
        a = (ulong64)0 - a;
        hi = -1.0f;
    } else {
        hi = 1.0f;
    }

    // 64-bit fraction to float without losing small ones: top 24 significant bits
    shift = 0u;
    while (shift < 40u && !(a >> 63)) {
        a <<= 1;
        shift++;
    }

    frac = (float)(uint)(a >> 40) * 5.96046448e-08f * k_pow2i(-(int)shift);
    frac = hi * frac * 1.57079637f;
    if (x < 0.0f) {
        frac = -frac;
        q = -q;
    }

    *quadrant = q & 3;
    return frac;
}

FN float k_reduce(float x, PRIVATE(int) quadrant) {
    float n;
    if (!(fabs_(x) < 8192.0f)) {
        if (!(fabs_(x) < 3.4e38f)) {
            *quadrant = 0;
            return 0.0f;
        }
        return k_reduce_far(x, quadrant);
    }

    n = floor_(x * 0.636619772f + 0.5f);
    *quadrant = (int)n & 3;
    return ((x - n * 1.5703125f) - n * 0.000483751297f) - n * 7.54953362e-08f - n * 2.56334415e-12f;
}

FN float k_sin_octant(float r) {  // |r| <= pi/4
    float z = r * r, p = 2.71834301e-06f;
    p = p * z - 0.000198393391f;
    p = p * z + 0.00833332911f;
    p = p * z - 0.166666672f;
    return r + r * z * p;
}

FN float k_cos_octant(float r) {
    float z = r * r, p = -2.72117688e-07f;
    p = p * z + 2.47995413e-05f;
    p = p * z - 0.00138888834f;
    p = p * z + 0.0416666679f;
    return 1.0f - (0.5f * z - z * z * p);
}

// The quadrant of a random angle cannot be foreseen, so no branch asks for it: sine and cosine change places, and their
// signs, by bits.
FN void k_sincos(float x, PRIVATE(float) sine, PRIVATE(float) cosine) {
    int q;
    float r = k_reduce(x, &q);
    uint sn = as_uint_(k_sin_octant(r)), cs = as_uint_(k_cos_octant(r)), quadrant = (uint)q;
    uint exchanged = (sn ^ cs) & (0u - (quadrant & 1u));
    *sine = as_float_((sn ^ exchanged) ^ (quadrant & 2u) << 30);
    *cosine = as_float_((cs ^ exchanged) ^ ((quadrant + 1u) & 2u) << 30);
}

FN float k_sin(float x) {
    int q;
    float r = k_reduce(x, &q);
    float v = (q & 1) ? k_cos_octant(r) : k_sin_octant(r);
    return (q & 2) ? -v : v;
}

FN float k_cos(float x) {
    int q;
    float r = k_reduce(x, &q);
    float v = (q & 1) ? k_sin_octant(r) : k_cos_octant(r);
    return ((q + 1) & 2) ? -v : v;
}

FN float k_tan(float x) {
    int q;
    float r = k_reduce(x, &q);
    float sn = k_sin_octant(r), cs = k_cos_octant(r);
    return (q & 1) ? -cs / sn : sn / cs;
}

FN float k_atan(float x) {
    float a = fabs_(x), base = 0.0f, rest = 0.0f, z, p;
    if (a > 2.41421356f) {
        base = 1.57079637f;
        rest = -4.37113901e-08f;
        a = -1.0f / a;
    } else if (a > 0.414213562f) {
        base = 0.785398185f;
        rest = -2.1855695e-08f;
        a = (a - 1.0f) / (a + 1.0f);
    }

    z = a * a;
    p = -0.0608898103f;
    p = p * z + 0.105987735f;
    p = p * z - 0.142443314f;
    p = p * z + 0.199985236f;
    p = p * z - 0.333333164f;
    a = base + (a + (a * z * p + rest));
    return x < 0.0f ? -a : a;
}

FN float k_atan2(float y, float x) {  // atan2(0, 0) = 0
    float ax = fabs_(x), ay = fabs_(y), a;
    if (ax == 0.0f && ay == 0.0f) return 0.0f;
    if (ay > ax) a = 1.57079637f - (k_atan(ax / ay) + 4.37113901e-08f);
    else a = k_atan(ay / ax);
    if (x < 0.0f) a = 3.14159274f - (a + 8.74227801e-08f);
    return y < 0.0f ? -a : a;
}

FN float k_asin_half(float x) {  // |x| <= 1/2
    float z = x * x, p = 0.0374822803f;
    p = p * z + 0.0144674992f;
    p = p * z + 0.0317984037f;
    p = p * z + 0.0445183665f;
    p = p * z + 0.0750049427f;
    p = p * z + 0.166666597f;
    return x + x * z * p;
}

FN float k_asin(float x) {
    float a = fabs_(x), v;
    if (a <= 0.5f) return k_asin_half(x);
    if (!(a < 1.0f)) v = 1.57079637f;
    else v = 1.57079637f - (2.0f * k_asin_half(sqrt_(0.5f * (1.0f - a))) + 4.37113901e-08f);
    return x < 0.0f ? -v : v;
}

FN float k_acos(float x) {
    float a = fabs_(x), v;
    if (a <= 0.5f) return 1.57079637f - (k_asin_half(x) + 4.37113901e-08f);
    if (!(a < 1.0f)) return x > 0.0f ? 0.0f : K_PI;
    v = 2.0f * k_asin_half(sqrt_(0.5f * (1.0f - a)));
    return x > 0.0f ? v : 3.14159274f - (v + 8.74227801e-08f);
}
#endif
