// SPDX-License-Identifier: BSD-3-Clause
// Zones of the field of view, around the line of sight.
#pragma once
#include "region/shape.h"

namespace region {
Field make_zone(const Shape& shape, const Space& space);
}
