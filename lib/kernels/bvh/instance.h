// SPDX-License-Identifier: BSD-3-Clause
// Instances: one geometry in several places.  Hit.inst is the number of an Instance (records.h).  Its two
// matrices are similarities (rotation, mirror, scale), three rows of four, from world points relative to the scene's
// centre: one to the tree that was hit, one to the coordinates of the functions of its modifiers.
#ifndef LUX_INSTANCE_H
#define LUX_INSTANCE_H

FN int in_instance(uint inst) { return HAS(INSTANCES) && inst != NO_HIT; }

FN GLOBAL const float* instance_matrix(TABLES(const SceneTables) s, GLOBAL const Instance* record) {
    return shape_record(s, record->shape) + INSTANCE_MATRIX;
}
#endif
