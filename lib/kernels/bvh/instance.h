// SPDX-License-Identifier: BSD-3-Clause
// Instances: one geometry in several places.  Hit.inst is a record of INST_* (tables.h) in SceneTables.shapes.  Its two
// matrices are similarities (rotation, mirror, scale), three rows of four, from world points relative to the scene's
// centre: one to the tree that was hit, one to the coordinates of the functions of its modifiers.
#ifndef LUX_INSTANCE_H
#define LUX_INSTANCE_H

FN int in_instance(uint inst) { return HAS(INSTANCES) && inst != NO_HIT; }

FN GLOBAL const float* instance_record(TABLES(const SceneTables) s, uint inst) { return shape_record(s, inst); }

FN GLOBAL const float* instance_matrix(TABLES(const SceneTables) s, GLOBAL const float* record) {
    return shape_record(s, as_uint_(record[INST_SHAPE])) + INSTANCE_MATRIX;
}
#endif
