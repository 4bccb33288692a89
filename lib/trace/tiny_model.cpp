// SPDX-License-Identifier: BSD-3-Clause
// See tiny_model.h: 32 x 32 rays of the view, and the median of their lengths.
#include "trace/tiny_model.h"

#include <fmt/core.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "base/error.h"
#include "kernels/host.h"

namespace kernels {
#include "kernels/offset_ray.h"
}

namespace trace {

void warn_of_tiny_model(const flatten::HostTracer& tracer, const view::View& view) {
    constexpr int side = 32;
    constexpr double near = 1000 * double(OFFSET_FLOOR), far = std::numeric_limits<double>::max();
    const view::Projector projector(view);
    std::vector<double> lengths;
    for (int y = 0; y < side; y++)
        for (int x = 0; x < side; x++) {
            const auto ray = projector.ray((x + .5) / side, (y + .5) / side);
            if (!ray) continue;
            const auto found = tracer.closest(ray->origin, ray->dir, 0, 1e30, flatten::HostTracer::all);
            lengths.push_back(found.t < 0 ? far : found.t);
        }
    if (lengths.empty()) return;
    const auto middle = lengths.begin() + long(lengths.size() / 2);
    std::nth_element(lengths.begin(), middle, lengths.end());
    if (*middle >= near) return;
    base::warn("", fmt::format("half of what the eye sees is less than {:.3f} away; in so small a model light is lost "
                               "near edges: is it in kilometres?  \"!xform -s 1000 model.rad\" makes metres of them",
                               near));
}

}  // namespace trace
