// SPDX-License-Identifier: BSD-3-Clause
// float3 algebra by functions, because C++ and OpenCL C share no operators here.
#ifndef LUX_VEC_H
#define LUX_VEC_H
FN float3 f3_at(GLOBAL const float* f) { return F3(f[0], f[1], f[2]); }
FN float3 add3(float3 a, float3 b) { return F3(a.x + b.x, a.y + b.y, a.z + b.z); }
FN float3 sub3(float3 a, float3 b) { return F3(a.x - b.x, a.y - b.y, a.z - b.z); }
FN float3 mul3(float3 a, float3 b) { return F3(a.x * b.x, a.y * b.y, a.z * b.z); }
FN float3 scale3(float3 a, float s) { return F3(a.x * s, a.y * s, a.z * s); }
FN float axis3(float3 v, uint k) { return k == 0u ? v.x : k == 1u ? v.y : v.z; }
FN float3 neg3(float3 a) { return F3(-a.x, -a.y, -a.z); }
FN float3 madd3(float3 a, float s, float3 b) { return F3(a.x * s + b.x, a.y * s + b.y, a.z * s + b.z); }
FN float dot3(float3 a, float3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
FN float3 cross3(float3 a, float3 b) { return F3(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x); }
FN float length3(float3 a) { return sqrt_(dot3(a, a)); }

FN float3 unit3(float3 a) {
    float len = length3(a);
    return len > 0.0f ? scale3(a, 1.0f / len) : a;
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
FN float3 affine_vector(GLOBAL const float* rows, float3 v) {
    return F3(rows[0] * v.x + rows[1] * v.y + rows[2] * v.z, rows[4] * v.x + rows[5] * v.y + rows[6] * v.z,
              rows[8] * v.x + rows[9] * v.y + rows[10] * v.z);
}

FN float3 affine_point(GLOBAL const float* rows, float3 p) {
    return F3(rows[0] * p.x + rows[1] * p.y + rows[2] * p.z + rows[3],
              rows[4] * p.x + rows[5] * p.y + rows[6] * p.z + rows[7],
              rows[8] * p.x + rows[9] * p.y + rows[10] * p.z + rows[11]);
}

// The same for a matrix whose fourth column is the point that goes to 0: near it, coordinates lose no digits.
FN float3 instance_point(GLOBAL const float* rows, float3 p) {
    return affine_vector(rows, sub3(p, F3(rows[3], rows[7], rows[11])));
}

// The transposed linear part: of a similarity of scale k it is k^2 times the inverse.
FN float3 affine_back(GLOBAL const float* rows, float3 v) {
    return F3(rows[0] * v.x + rows[4] * v.y + rows[8] * v.z, rows[1] * v.x + rows[5] * v.y + rows[9] * v.z,
              rows[2] * v.x + rows[6] * v.y + rows[10] * v.z);
}

FN float affine_scale2(GLOBAL const float* rows) {
    return rows[0] * rows[0] + rows[1] * rows[1] + rows[2] * rows[2];
}  // k^2
#endif
