// SPDX-License-Identifier: BSD-3-Clause
// Elementary functions in float, the same bits on every device (built-in ones differ, and PoCL's are slow).
// exp, log, pow and erf; angles in math_trig.h, which is part of this file.
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
FN float k_pow2i(int n) { return as_float_((uint)(n + 127) << 23); }

// v 2^n, n within twice the range of a float's exponent
FN float k_scale(float v, int n) {
    int h = n / 2;
    return v * k_pow2i(h) * k_pow2i(n - h);
}

// The upper 12 bits of the significand: products of two such numbers are exact.
FN float k_head(float x) { return as_float_(as_uint_(x) & 0xfffff000u); }

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
    return k_scale(1.0f + (r + r * r * p), (int)n);
}

// x = m 2^e with m in [sqrt(1/2), sqrt(2)), for normal x > 0
FN float k_split(float x, PRIVATE(int) e) {
    uint u = as_uint_(x) - 0x3f3504f3u;
    *e = (int)u >> 23;
    return as_float_((u & 0x007fffffu) + 0x3f3504f3u);
}

FN float k_log(float x) {
    int ie;
    float m, f, p, e;
    if (!(x >= 1.17549435e-38f)) return -K_INF;
    if (as_uint_(x) >= 0x7f800000u) return x;
    m = k_split(x, &ie);
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
    float whole = k_log(x), h, t;
    if (!(fabs_(whole) < 100.0f)) return whole;
    h = k_head(whole);
    t = whole - h;
    return h * 0.434204102f + (h * 9.03799083e-05f + t * 0.434294482f);
}

// log2 of normal x > 0 as an unevaluated sum hi + lo, through s = (m-1)/(m+1): ln m = 2 (s + s^3/3 + ...)
FN float k_log2_split(float x, PRIVATE(float) lo) {
    int ie;
    float m = k_split(x, &ie), e = (float)ie;
    float num = m - 1.0f, den = m + 1.0f;
    float s = num / den;
    float sh = k_head(s), dh = k_head(den);
    float dl = m - (dh - 1.0f);
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

FN float k_exp2_frac(float r) {  // 2^r - 1 for |r| <= 1/2
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
    h = k_log2_split(x, &lo);
    hh = k_head(h);
    hl = (h - hh) + lo;
    yh = k_head(y);
    yl = y - yh;
    ph = yh * hh;  // exact
    pl = yl * hh + y * hl;
    if (ph + pl < -126.0f) return 0.0f;
    if (ph + pl >= 128.0f) return sign * K_INF;
    n = floor_(ph + pl + 0.5f);
    return sign * k_scale(1.0f + k_exp2_frac((ph - n) + pl), (int)n);
}

// erfc(a) exp(a a) t as a polynomial in t = 2/(2+a), for a >= 1
FN float k_erfc_tail(float a) {
    float t = 2.0f / (2.0f + a), p = -0.124913506f, h = k_head(a);
    float l = a - h;
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
        p = a > 4.0f ? 1.0f : 1.0f - k_erfc_tail(a);
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
    if (x >= 1.0f) return x > 9.3f ? 0.0f : k_erfc_tail(x);
    if (x <= -1.0f) return x < -4.0f ? 2.0f : 2.0f - k_erfc_tail(-x);
    return 1.0f - k_erf(x);
}
#include "kernels/math/math_trig.h"
#endif
