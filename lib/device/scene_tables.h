// SPDX-License-Identifier: BSD-3-Clause
// The tables of a pass for kernels of this processor, which read them in place.
#pragma once
#include "device/device.h"

namespace device {

#define POINT_AT_BVH(type, name) tables.name = scene.built.wide->name.data();
#define POINT_AT_SCENE(type, name) tables.name = scene.name.data();
#define POINT_AT_VIEW(type, name) tables.name = par.view_tables->name.data();

inline kernels::SceneTables tables_of(const flatten::FlatScene& scene, const Params& par) {
    kernels::SceneTables tables{};
    BVH_TABLES(POINT_AT_BVH)
    FLAT_TABLES(POINT_AT_SCENE)
    if (par.view_tables) {
        VIEW_TABLES(POINT_AT_VIEW)
    }
    return tables;
}

}  // namespace device
