// SPDX-License-Identifier: BSD-3-Clause
// Instances: one geometry in several places (Instance of records.h).  The two matrices are similarities (rotation,
// mirror, scale) from world points relative to the scene's centre.
#ifndef LUX_INSTANCE_H
#define LUX_INSTANCE_H

FN int in_instance(uint inst) { return HAS(INSTANCES) && inst != NO_HIT; }
#endif
