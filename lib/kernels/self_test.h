// SPDX-License-Identifier: BSD-3-Clause
// Elementary results, for arguments that depend on i alone: a device that gives the host's bits for them is trusted to
// give all others (lib/render/self_test.h).
#ifndef LUX_SELF_TEST_H
#define LUX_SELF_TEST_H

#define SELF_TEST_INPUTS 64u
#define SELF_TEST_VALUES 8u  // of each

// A float of either sign, from 2^-least to 2^(8-least).
FN float self_test_argument(uint i, uint which, uint least) {
    uint word = hash32(8u * i + which);
    return as_float_((word & 0x807fffffu) | ((127u - least + (word >> 23 & 7u)) << 23));
}

// value 0 .. SELF_TEST_VALUES - 1, in the order of `operations` in lib/render/self_test.cpp.
FN float self_test_value(uint i, uint value) {
    float a = self_test_argument(i, 0u, 4u), b = self_test_argument(i, 1u, 4u), c = self_test_argument(i, 2u, 4u);
    float sine, cosine;
    switch (value) {
    case 0: return a * b + c;
    case 1: return a / b;
    case 2: return sqrt_(fabs_(a));
    case 3: return as_float_(as_uint_(a) & 0x807fffffu) * 0.5f;  // subnormal
    case 4: return k_exp(a);
    case 5: k_sincos(a * c, &sine, &cosine); return sine + 2.0f * cosine;
    case 6: return k_pow(fabs_(a), b);
    default: return (float)cal_noise3((cal_real)a, (cal_real)b, (cal_real)c);
    }
}
#endif
