// SPDX-License-Identifier: BSD-3-Clause
// Models in kilometres: told of, because rays leave surfaces by a least length (kernels/offset_ray.h).
#pragma once
#include "flatten/host_tracer.h"
#include "view/view.h"

namespace trace {

// Warns if half of what the eye sees is nearer than a thousand times that length: then light near edges is lost.
// An office in kilometres has 1.5 % less of it at the eye.  What is near the eye tells the unit; the size of the scene
// does not, for grounds are large, nor does that of its surfaces, for meshes are fine.
void warn_of_tiny_model(const flatten::HostTracer& tracer, const view::View& view);

}  // namespace trace
