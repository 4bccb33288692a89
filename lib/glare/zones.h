// SPDX-License-Identifier: BSD-3-Clause
// Zones of -l and -L, by direction.
#pragma once
#include "glare/geometry.h"
#include "glare/settings.h"
#include "glare/threshold.h"

namespace glare {

class ZoneBorders {
public:
    ZoneBorders(const Geometry& g, const Zones& zones)
        : geometry_(g),
          centre_(g.direction(zones.inner.x, zones.inner.y)),
          inner_(inside_cosine(zones.inner.opening)),
          outer_(zones.outer_opening ? inside_cosine(*zones.outer_opening) : 2) {}
    // 1: inside the inner circle; 2: between the circles; 0: outside.
    int zone_of(size_t pixel) const {
        const double c = dot(centre_, geometry_.direction(pixel));
        return geometry_.inside(c, inner_) ? 1 : geometry_.inside(c, outer_) ? 2 : 0;
    }

private:
    const Geometry& geometry_;
    Vec3 centre_;
    double inner_, outer_;  // cosines
};

}  // namespace glare
