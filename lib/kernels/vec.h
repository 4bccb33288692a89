// SPDX-License-Identifier: BSD-3-Clause
// float3 algebra by functions, because C++ and OpenCL C share no operators here.
#ifndef LUX_VEC_H
#define LUX_VEC_H
#define MIN_(a, b) ((a) < (b) ? (a) : (b))
#define MAX_(a, b) ((a) > (b) ? (a) : (b))
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
FN float min3(float3 a) {
    float m = MIN_(a.x, a.y);
    return MIN_(m, a.z);
}
#endif
