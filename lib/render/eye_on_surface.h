// SPDX-License-Identifier: BSD-3-Clause
// Does the eye lie on a surface (PF_EYE_ON_SURFACE)?  Its rays are not to meet that (RADIANCE: nothing within 1e-6
// stops a ray), but rounding decides on which side of it they begin; so it is looked for where it may be, and only
// there.
#pragma once
#include "flatten/flat_scene.h"
#include "flatten/host_tracer.h"

namespace render {

bool eye_on_surface(const flatten::FlatScene& flat, const flatten::HostTracer& tracer, base::Vec3 eye);

}  // namespace render
