// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions in float, the same bits on every device (built-in ones differ, and PoCL's are slow).
// Method: exact argument reduction (Cody-Waite, Payne-Hanek for huge angles) and polynomials fitted to the least
// largest relative error on the reduced range.  Only + - * / sqrt and integer work, no fused operations.
// Accuracy (tests/unit/kernels_math_test.cpp, against double): 2.5 ulp or better, k_tan 3.5, k_erfc 16.
// Extremes never trap: k_exp is 0 below -87.33 (results that would be denormal count as 0), infinite above 88.72;
// k_log, k_log10 of 0 or less give -infinity; k_pow outside its domain gives 0; asin and acos clamp to [-1,1].
#ifndef LUX_MATH_H
#define LUX_MATH_H

#define K_PI 3.14159265f
#define K_TURN 6.28318531f  // 2 pi
#define K_INV_PI 0.31830989f
#define K_RADIANS 0.01745329252f  // of a degree
#define K_INF as_float_(0x7f800000u)

// 2^n for -126 <= n <= 127
FN float k_pow2i_(int n) { return as_float_((uint)(n + 127) << 23); }

// v 2^n, n within twice the range of a float's exponent
FN float k_scale_(float v, int n) {
    int h = n / 2;
    return v * k_pow2i_(h) * k_pow2i_(n - h);
}

// The upper 12 bits of the significand: products of two such numbers are exact.
FN float k_head_(float x) { return as_float_(as_uint_(x) & 0xfffff000u); }

FN float k_exp(float x) {
    if (!(x > -87.33f)) return 0.0f;
    if (x > 88.7228f) return K_INF;
    float n = floor_(x * 1.44269504f + 0.5f);
    float r = (x - n * 0.693115234f) - n * 3.19461849e-05f;
    float p = 0.000199182017f;
    p = p * r + 0.00139458093f;
    p = p * r + 0.00833326485f;
    p = p * r + 0.041666273f;
    p = p * r + 0.166666672f;
    p = p * r + 0.5f;
    return k_scale_(1.0f + (r + r * r * p), (int)n);
}

// x = m 2^e with m in [sqrt(1/2), sqrt(2)), for normal x > 0
FN float k_split_(float x, PRIVATE int* e) {
    uint u = as_uint_(x) - 0x3f3504f3u;
    *e = (int)u >> 23;
    return as_float_((u & 0x007fffffu) + 0x3f3504f3u);
}

FN float k_log(float x) {
    int ie;
    float m, f, p, e;
    if (!(x >= 1.17549435e-38f)) return -K_INF;
    if (as_uint_(x) >= 0x7f800000u) return x;
    m = k_split_(x, &ie);
    f = m - 1.0f;
    e = (float)ie;
    p = 0.0674726889f;
    p = p * f - 0.116751604f;
    p = p * f + 0.11887569f;
    p = p * f - 0.124056347f;
    p = p * f + 0.142196491f;
    p = p * f - 0.166679963f;
    p = p * f + 0.200021133f;
    p = p * f - 0.250000089f;
    p = p * f + 0.333333135f;
    p = f * f * f * p + e * 3.19461849e-05f;
    p = p - 0.5f * f * f;
    return e * 0.693115234f + (f + p);
}

FN float k_log10(float x) {
    float l = k_log(x), h, t;
    if (!(fabs_(l) < 100.0f)) return l;
    h = k_head_(l);
    t = l - h;
    return h * 0.434204102f + (h * 9.03799083e-05f + t * 0.434294482f);
}

// log2 of normal x > 0 as an unevaluated sum hi + lo, through s = (m-1)/(m+1): ln m = 2 (s + s^3/3 + ...)
FN float k_log2_(float x, PRIVATE float* lo) {
    int ie;
    float m = k_split_(x, &ie), e = (float)ie;
    float num = m - 1.0f, den = m + 1.0f, s = num / den;
    float sh = k_head_(s), dh = k_head_(den), dl = m - (dh - 1.0f);
    float sl = ((num - sh * dh) - sh * dl) / den, z = s * s;
    float p = 0.235825986f, a, h, t;
    p = p * z + 0.285372853f;
    p = p * z + 0.400003344f;
    p = p * z + 0.666666627f;
    t = 2.0f * sl + s * z * p;
    a = 2.0f * sh;
    h = a * 1.44238281f;  // exact: 12 by 12 bits
    t = a * 0.000312228389f + t * 1.44269504f;
    a = e + h;
    *lo = (h - (a - e)) + t;
    return a;
}

FN float k_exp2_frac_(float r) {  // 2^r - 1 for |r| <= 1/2
    float p = 1.53149304e-05f;
    p = p * r + 0.000154670925f;
    p = p * r + 0.0013333431f;
    p = p * r + 0.00961803738f;
    p = p * r + 0.0555041097f;
    p = p * r + 0.240226507f;
    p = p * r + 0.693147182f;
    return r * p;
}

// x^y: 0^y = 0 for y > 0, x^0 = 1; a negative x needs a whole y; 0 outside the domain.
FN float k_pow(float x, float y) {
    float sign = 1.0f, lo, h, hh, hl, yh, yl, ph, pl, n;
    if (y == 0.0f) return 1.0f;
    if (x < 0.0f) {
        if (floor_(y) != y) return 0.0f;
        if (fabs_(y) < 16777216.0f && ((int)fabs_(y) & 1)) sign = -1.0f;
        x = -x;
    }
    if (!(x >= 1.17549435e-38f)) return 0.0f;
    if (as_uint_(x) >= 0x7f800000u) return y > 0.0f ? sign * x : 0.0f;
    if (!(fabs_(y) < 1e12f)) y = y > 0.0f ? 1e12f : -1e12f;
    h = k_log2_(x, &lo);
    hh = k_head_(h);
    hl = (h - hh) + lo;
    yh = k_head_(y);
    yl = y - yh;
    ph = yh * hh;  // exact
    pl = yl * hh + y * hl;
    if (ph + pl < -126.0f) return 0.0f;
    if (ph + pl >= 128.0f) return sign * K_INF;
    n = floor_(ph + pl + 0.5f);
    return sign * k_scale_(1.0f + k_exp2_frac_((ph - n) + pl), (int)n);
}

// The quarter turns in x and the rest in [-pi/4, pi/4], for |x| above 2^13: x = m 2^k times 192 bits of 2/pi.
FN float k_reduce_far_(float x, PRIVATE int* quadrant) {
    uint two_over_pi[8];
    uint u = as_uint_(x), m = (u & 0x007fffffu) | 0x00800000u, word, shift, w0, w1, w2;
    int k = (int)((u >> 23) & 255u) - 150, q;  // x = m 2^k, k >= -10
    ulong64 a, b, c;
    float hi, frac;
    two_over_pi[0] = 0u;
    two_over_pi[1] = 0xa2f9836eu;
    two_over_pi[2] = 0x4e441529u;
    two_over_pi[3] = 0xfc2757d1u;
    two_over_pi[4] = 0xf534ddc0u;
    two_over_pi[5] = 0xdb629599u;
    two_over_pi[6] = 0x3c439041u;
    two_over_pi[7] = 0xfe5163abu;
    // m 2^k 2/pi mod 4: the bits of 2/pi from weight 2^(1-k) down matter; the window starts k + 30 bits after the
    // top of the table (32 zero bits, then the fraction), so that its top bit has weight 2^(1-k).
    word = (uint)(k + 30) >> 5;
    shift = (uint)(k + 30) & 31u;
    w0 = two_over_pi[word];
    w1 = two_over_pi[word + 1u];
    w2 = two_over_pi[word + 2u];
    if (shift) {
        w0 = (w0 << shift) | (w1 >> (32u - shift));
        w1 = (w1 << shift) | (w2 >> (32u - shift));
        w2 = (w2 << shift) | (word + 3u < 8u ? two_over_pi[word + 3u] >> (32u - shift) : 0u);
    }
    // 96-bit product, modulo 2^96 = modulo 4: its top two bits are the quadrant.
    a = (ulong64)w0 * m;
    b = (ulong64)w1 * m;
    c = (ulong64)w2 * m;
    b += c >> 32;
    a = ((a & 0xffffffffu) << 32) + b;
    q = (int)(a >> 62);
    a <<= 2;        // fraction of a quarter turn, 64 bits
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
    frac = (float)(uint)(a >> 40) * 5.96046448e-08f * k_pow2i_(-(int)shift);
    frac = hi * frac * 1.57079637f;
    if (x < 0.0f) {
        frac = -frac;
        q = -q;
    }
    *quadrant = q & 3;
    return frac;
}

FN float k_reduce_(float x, PRIVATE int* quadrant) {
    float n;
    if (!(fabs_(x) < 8192.0f)) {
        if (!(fabs_(x) < 3.4e38f)) {
            *quadrant = 0;
            return 0.0f;
        }
        return k_reduce_far_(x, quadrant);
    }
    n = floor_(x * 0.636619772f + 0.5f);
    *quadrant = (int)n & 3;
    return ((x - n * 1.5703125f) - n * 0.000483751297f) - n * 7.54953362e-08f - n * 2.56334415e-12f;
}

FN float k_sin_(float r) {  // |r| <= pi/4
    float z = r * r, p = 2.71834301e-06f;
    p = p * z - 0.000198393391f;
    p = p * z + 0.00833332911f;
    p = p * z - 0.166666672f;
    return r + r * z * p;
}
FN float k_cos_(float r) {
    float z = r * r, p = -2.72117688e-07f;
    p = p * z + 2.47995413e-05f;
    p = p * z - 0.00138888834f;
    p = p * z + 0.0416666679f;
    return 1.0f - (0.5f * z - z * z * p);
}

FN void k_sincos(float x, PRIVATE float* sine, PRIVATE float* cosine) {
    int q;
    float r = k_reduce_(x, &q), s = k_sin_(r), c = k_cos_(r);
    float a = (q & 1) ? c : s, b = (q & 1) ? s : c;
    *sine = (q & 2) ? -a : a;
    *cosine = ((q + 1) & 2) ? -b : b;
}
FN float k_sin(float x) {
    int q;
    float r = k_reduce_(x, &q), v = (q & 1) ? k_cos_(r) : k_sin_(r);
    return (q & 2) ? -v : v;
}
FN float k_cos(float x) {
    int q;
    float r = k_reduce_(x, &q), v = (q & 1) ? k_sin_(r) : k_cos_(r);
    return ((q + 1) & 2) ? -v : v;
}
FN float k_tan(float x) {
    int q;
    float r = k_reduce_(x, &q), s = k_sin_(r), c = k_cos_(r);
    return (q & 1) ? -c / s : s / c;
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

FN float k_asin_(float x) {  // |x| <= 1/2
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
    if (a <= 0.5f) return k_asin_(x);
    if (!(a < 1.0f)) v = 1.57079637f;
    else v = 1.57079637f - (2.0f * k_asin_(sqrt_(0.5f * (1.0f - a))) + 4.37113901e-08f);
    return x < 0.0f ? -v : v;
}
FN float k_acos(float x) {
    float a = fabs_(x), v;
    if (a <= 0.5f) return 1.57079637f - (k_asin_(x) + 4.37113901e-08f);
    if (!(a < 1.0f)) return x > 0.0f ? 0.0f : K_PI;
    v = 2.0f * k_asin_(sqrt_(0.5f * (1.0f - a)));
    return x > 0.0f ? v : 3.14159274f - (v + 8.74227801e-08f);
}

// erfc(a) exp(a a) t as a polynomial in t = 2/(2+a), for a >= 1
FN float k_erfc_(float a) {
    float t = 2.0f / (2.0f + a), p = -0.124913506f, h = k_head_(a), l = a - h;
    p = p * t + 0.387905419f;
    p = p * t - 0.40075919f;
    p = p * t + 0.0990234241f;
    p = p * t - 0.0266398489f;
    p = p * t + 0.0713753328f;
    p = p * t + 0.183804005f;
    p = p * t + 0.245059863f;
    p = p * t + 0.282298803f;
    p = p * t + 0.282085449f;
    return t * p * k_exp(-h * h) * k_exp(-l * (h + a));
}
FN float k_erf(float x) {
    float a = fabs_(x), z = x * x, p;
    if (a >= 1.0f) {
        p = a > 4.0f ? 1.0f : 1.0f - k_erfc_(a);
        return x < 0.0f ? -p : p;
    }
    p = -9.64151423e-06f;
    p = p * z + 0.000112569469f;
    p = p * z - 0.000848282885f;
    p = p * z + 0.00522094546f;
    p = p * z - 0.0268654004f;
    p = p * z + 0.112837821f;
    p = p * z - 0.376126379f;
    p = p * z + 1.12837923f;
    return x * p;
}
FN float k_erfc(float x) {
    if (x >= 1.0f) return x > 9.3f ? 0.0f : k_erfc_(x);
    if (x <= -1.0f) return x < -4.0f ? 2.0f : 2.0f - k_erfc_(-x);
    return 1.0f - k_erf(x);
}
#endif
