// SPDX-License-Identifier: BSD-3-Clause
// The noise functions of .cal files: noise3 (Perlin, "Improving Noise", 2002: gradient noise of period 256), its
// backward differences over 0.0005, fnoise3 (fractal midpoint displacement on a 2000-fold lattice) and rand(x).
// They need more than float: double where the device has it (LUX_DOUBLE), else float with 3 digits less in the
// differences and another rand().
#ifndef LUX_CAL_NOISE_H
#define LUX_CAL_NOISE_H

#ifdef LUX_DOUBLE
typedef double cal_real;
#define CAL_REAL(x) x
#else
typedef float cal_real;
#define CAL_REAL(x) x##f
#endif

// Perlin's published permutation of 0..255, four to a word, the first in the top byte.
CONSTANT uint cal_permutation[64] = {
    0x97a0895bu, 0x5a0f830du, 0xc95f6035u, 0xc2e907e1u, 0x8c24671eu, 0x458e0863u, 0x25f0150au, 0x17be0694u,
    0xf778ea4bu, 0x001ac53eu, 0x5efcdbcbu, 0x75230b20u, 0x39b12158u, 0xed953857u, 0xae147d88u, 0xaba844afu,
    0x4aa54786u, 0x8b301ba6u, 0x4d929ee7u, 0x536fe57au, 0x3cd385e6u, 0xdc695c29u, 0x372ef528u, 0xf4668f36u,
    0x41193fa1u, 0x01d85049u, 0xd14c84bbu, 0xd05912a9u, 0xc8c48782u, 0x74bc9f56u, 0xa4646dc6u, 0xadba0340u,
    0x34d9e2fau, 0x7c7b05cau, 0x2693767eu, 0xff5255d4u, 0xcfce3be3u, 0x2f103a11u, 0xb6bd1c2au, 0xdfb7aad5u,
    0x77f89802u, 0x2c9aa346u, 0xdd99659bu, 0xa72bac09u, 0x811627fdu, 0x13626c6eu, 0x4f71e0e8u, 0xb2b97068u,
    0xdaf661e4u, 0xfb22f2c1u, 0xeed2900cu, 0xbfb3a2f1u, 0x513391ebu, 0xf90eef6bu, 0x31c0d61fu, 0xb5c76a9du,
    0xb854ccb0u, 0x7379322du, 0x7f0496feu, 0x8aeccd5du, 0xde72431du, 0x1848f38du, 0x80c34e42u, 0xd73d9cb4u};

FN int cal_perm(int i) {
    uint k = (uint)i & 255u;
    return (int)((cal_permutation[k >> 2] >> (24u - 8u * (k & 3u))) & 255u);
}

FN cal_real cal_gradient(int hash, cal_real x, cal_real y, cal_real z) {
    int h = hash & 15;
    cal_real u = h < 8 ? x : y, v = h < 4 ? y : ((h == 12 || h == 14) ? x : z);
    return ((h & 1) ? -u : u) + ((h & 2) ? -v : v);
}

FN cal_real cal_fade(cal_real t) { return t * t * t * (t * (t * CAL_REAL(6.0) - CAL_REAL(15.0)) + CAL_REAL(10.0)); }

// Truncation, but into the cell below for negative numbers, whole ones included.
FN int cal_cell(cal_real x) {
    if (!(x > CAL_REAL(-1e9) && x < CAL_REAL(1e9))) return 0;
    return (int)x - (x < CAL_REAL(0.0) ? 1 : 0);
}

FN cal_real cal_noise3(cal_real x, cal_real y, cal_real z) {
    int xi = cal_cell(x), yi = cal_cell(y), zi = cal_cell(z);
    int a, b, aa, ab, ba, bb;
    cal_real u, v, w, low, high, l, h, one = CAL_REAL(1.0);
    x -= (cal_real)xi;
    y -= (cal_real)yi;
    z -= (cal_real)zi;
    u = cal_fade(x);
    v = cal_fade(y);
    w = cal_fade(z);
    a = cal_perm(xi) + yi;
    b = cal_perm(xi + 1) + yi;
    aa = cal_perm(a) + zi;
    ab = cal_perm(a + 1) + zi;
    ba = cal_perm(b) + zi;
    bb = cal_perm(b + 1) + zi;
    l = cal_gradient(cal_perm(aa), x, y, z);
    h = cal_gradient(cal_perm(ba), x - one, y, z);
    low = l + u * (h - l);
    l = cal_gradient(cal_perm(ab), x, y - one, z);
    h = cal_gradient(cal_perm(bb), x - one, y - one, z);
    l = l + u * (h - l);
    low = low + v * (l - low);
    l = cal_gradient(cal_perm(aa + 1), x, y, z - one);
    h = cal_gradient(cal_perm(ba + 1), x - one, y, z - one);
    high = l + u * (h - l);
    l = cal_gradient(cal_perm(ab + 1), x, y - one, z - one);
    h = cal_gradient(cal_perm(bb + 1), x - one, y - one, z - one);
    l = l + u * (h - l);
    high = high + v * (l - high);
    return low + w * (high - low);
}

// axis 0: noise3; 1, 2, 3: its slope along x, y, z
FN cal_real cal_noise3_slope(cal_real x, cal_real y, cal_real z, int axis) {
    cal_real n = cal_noise3(x, y, z), d = CAL_REAL(0.0005);
    if (axis == 0) return n;
    return (n - cal_noise3(axis == 1 ? x - d : x, axis == 2 ? y - d : y, axis == 3 ? z - d : z)) / d;
}

// Hash of a lattice point to [-1, 1), wrapping 64-bit arithmetic.
FN cal_real cal_lattice(long64 x, long64 y, long64 z) {
    ulong64 k = (ulong64)17 * (ulong64)x + (ulong64)23 * (ulong64)y + (ulong64)29 * (ulong64)z;
    k = (k << 13) ^ k;
    k = (k * (k * k * (ulong64)15731 + (ulong64)789221) + (ulong64)1376312589) & (ulong64)0x7fffffff;
    return CAL_REAL(1.0) - (cal_real)(uint)k * CAL_REAL(9.31322574615478515625e-10);
}

FN cal_real cal_whole(cal_real x) {  // floor; numbers of 1e15 and more are whole already
    cal_real t;
    if (!(x > CAL_REAL(-1e15) && x < CAL_REAL(1e15))) return x;
    t = (cal_real)(long64)x;
    return t > x ? t - CAL_REAL(1.0) : t;
}

// 2000 x; a float within rounding of a lattice plane counts as on it, as the double it stands for would be.
FN cal_real cal_lattice_place(cal_real x) {
    cal_real t = x * CAL_REAL(2000.0), near, off;
    if (!(t > CAL_REAL(-2e12) && t < CAL_REAL(2e12))) return CAL_REAL(0.0);
    near = cal_whole(t + CAL_REAL(0.5));
    off = t - near;
    return off * off <= near * near * CAL_REAL(1.4e-14) ? near : t;
}

FN cal_real cal_fnoise3(cal_real x, cal_real y, cal_real z) {
    long64 t[3], b[3], m[3], size = 2000;
    cal_real f[8], old[8], p[3], c, scale;
    int i, j, branch, sign[3];
    p[0] = cal_lattice_place(x);
    p[1] = cal_lattice_place(y);
    p[2] = cal_lattice_place(z);
    for (i = 0; i < 3; i++) {
        t[i] = (long64)p[i];
        b[i] = 2000 * (long64)cal_whole(p[i] / CAL_REAL(2000.0));
    }

    for (j = 0; j < 8; j++)
        f[j] = cal_lattice(b[0] + ((j & 1) ? size : 0), b[1] + ((j & 2) ? size : 0), b[2] + ((j & 4) ? size : 0));

    for (;;) {
        c = CAL_REAL(0.0);
        for (j = 0; j < 8; j++) {
            old[j] = f[j];
            c += f[j];
        }
        c = c * CAL_REAL(0.125);
        size = size >> 1;
        if (size == 0) return c;
        scale = CAL_REAL(0.0005) * (cal_real)size;
        branch = 0;
        for (i = 0; i < 3; i++) {
            m[i] = b[i] + size;
            if (t[i] > m[i]) {
                branch |= 1 << i;
                sign[i] = 1;
            } else {
                sign[i] = -1;
            }
        }
        f[7 & ~branch] = c + scale * cal_lattice(m[0], m[1], m[2]);
        for (i = 0; i < 3; i++) {
            long64 d = size * sign[i];
            long64 dx = i == 0 ? d : 0, dy = i == 1 ? d : 0, dz = i == 2 ? d : 0;
            cal_real face = CAL_REAL(0.0);
            for (j = 0; j < 8; j++)
                if (((j ^ branch) & (1 << i)) == 0) face += old[j];
            f[7 & ~(branch ^ (1 << i))] = face * CAL_REAL(0.25) + scale * cal_lattice(m[0] + dx, m[1] + dy, m[2] + dz);
            dx = i == 0 ? 0 : size * sign[0];
            dy = i == 1 ? 0 : size * sign[1];
            dz = i == 2 ? 0 : size * sign[2];
            f[branch ^ (1 << i)] = (old[branch] + old[branch ^ (1 << i)]) * CAL_REAL(0.5) +
                                   scale * cal_lattice(m[0] + dx, m[1] + dy, m[2] + dz);
        }
        for (i = 0; i < 3; i++)
            if (branch & (1 << i)) b[i] += size;
    }
}

// RADIANCE's hash of a number to [0, 1)
FN cal_real cal_rand(cal_real x) {
    cal_real y = x * (CAL_REAL(1.0) / (CAL_REAL(1.0) + x * x) + CAL_REAL(2.71828182845904));
    y = y - cal_whole(y) + CAL_REAL(0.785398163397447);
    y = CAL_REAL(1e5) / y;
    return y - cal_whole(y);
}
#endif
