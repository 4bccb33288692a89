// SPDX-License-Identifier: BSD-3-Clause
// float3 algebra by functions, because C++ and OpenCL C share no operators here.
#ifndef LUX_VEC_H
#define LUX_VEC_H
#define MIN_(a, b) ((a) < (b) ? (a) : (b))
#define MAX_(a, b) ((a) > (b) ? (a) : (b))
FN float3 f3_at(GLOBAL const float* f) { return F3(f[0], f[1], f[2]); }
FN float3 add3(float3 a, float3 b) { return F3(a.x + b.x, a.y + b.y, a.z + b.z); }
FN float3 sub3(float3 a, float3 b) { return F3(a.x - b.x, a.y - b.y, a.z - b.z); }
FN float3 mul3(float3 a, float3 b) { return F3(a.x * b.x, a.y * b.y, a.z * b.z); }
FN float3 scale3(float3 a, float s) { return F3(a.x * s, a.y * s, a.z * s); }
FN float3 neg3(float3 a) { return F3(-a.x, -a.y, -a.z); }
FN float3 madd3(float3 a, float s, float3 b) { return F3(a.x * s + b.x, a.y * s + b.y, a.z * s + b.z); }
FN float dot3(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FN float3 cross3(float3 a, float3 b) { return F3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
FN float length3(float3 a) { return sqrt_(dot3(a, a)); }
FN float3 unit3(float3 a) {
    float l = length3(a);
    return l > 0.0f ? scale3(a, 1.0f / l) : a;
}
FN float max3(float3 a) {
    float m = MAX_(a.x, a.y);
    return MAX_(m, a.z);
}
// Of RADIANCE's primaries.
FN float luminance3(float3 c) { return 0.265074126f * c.x + 0.670114631f * c.y + 0.064811243f * c.z; }

FN float4 pack4(float3 v, float w) {
    float4 r;
    r.x = v.x;
    r.y = v.y;
    r.z = v.z;
    r.w = w;
    return r;
}
FN float3 xyz4(float4 v) { return F3(v.x, v.y, v.z); }

// Points and vectors through a matrix of three rows of four floats.
FN float3 affine_vector(GLOBAL const float* m, float3 v) {
    return F3(m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
              m[8] * v.x + m[9] * v.y + m[10] * v.z);
}
FN float3 affine_point(GLOBAL const float* m, float3 p) {
    return F3(m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
              m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]);
}
// The transposed linear part: of a similarity of scale k it is k^2 times the inverse.
FN float3 affine_back(GLOBAL const float* m, float3 v) {
    return F3(m[0] * v.x + m[4] * v.y + m[8] * v.z, m[1] * v.x + m[5] * v.y + m[9] * v.z,
              m[2] * v.x + m[6] * v.y + m[10] * v.z);
}
FN float affine_scale2(GLOBAL const float* m) { return m[0] * m[0] + m[1] * m[1] + m[2] * m[2]; }  // k^2
#endif
