// SPDX-License-Identifier: BSD-3-Clause
// Tests whether the eye lies on a surface (PF_EYE_ON_SURFACE).  The eye's rays must not hit that surface (RADIANCE: a
// hit within 1e-6 does not stop a ray), but rounding decides on which side of it they begin, so the surface is searched
// around the eye only.
#pragma once
#include "flatten/flat_scene.h"
#include "flatten/host_tracer.h"

namespace render {

bool eye_on_surface(const flatten::FlatScene& flat, const flatten::HostTracer& tracer, base::Vec3 eye);

}  // namespace render
