// SPDX-License-Identifier: BSD-3-Clause
// Instances: one geometry, many places.  Hit.inst is a record of INST_* (tables.h) in SceneTables.shapes.
// Its two matrices are similarities (rotation, mirror, scale), three rows of four, from world points relative to the
// scene's centre: one to the tree that was hit, one to the coordinates which the functions of its modifiers see.
#ifndef LUX_INSTANCE_H
#define LUX_INSTANCE_H

FN GLOBAL const float* instance_record(PRIVATE const SceneTables* s, uint inst) {
    return s->shapes + (ulong64)inst * SHAPE_FLOATS;
}
FN GLOBAL const float* instance_matrix(PRIVATE const SceneTables* s, GLOBAL const float* record) {
    return s->shapes + (ulong64)as_uint_(record[INST_SHAPE]) * SHAPE_FLOATS + 1;
}
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
