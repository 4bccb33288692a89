// SPDX-License-Identifier: BSD-3-Clause
// Layouts and constants of the device code for ordinary host files (no traversal, no shading): namespace kernels.
#pragma once
#include <cstdint>
#include <cstring>
#include <math.h>
#include <vector>
namespace kernels {
#include "kernels/dialect/compat_host.h"
#include "kernels/math/vec.h"
#include "kernels/math/math.h"
#include "kernels/bvh/intersect.h"
#include "kernels/tables.h"
#include "kernels/sampling/sampler.h"
#include "kernels/integrator/path_reuse.h"
#include "kernels/integrator/state.h"

// The tables of a scene as the host fills them.
#define TABLE_VECTOR(type, name) std::vector<type> name;
struct FlatTables {
    FLAT_TABLES(TABLE_VECTOR)
};
// The tables of a view, likewise.
struct ViewTables {
    VIEW_TABLES(TABLE_VECTOR)
};
}  // namespace kernels
