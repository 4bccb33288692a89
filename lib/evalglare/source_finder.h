// SPDX-License-Identifier: BSD-3-Clause
// Glare sources as evalglare finds them, to the last bit (-like evalglare): its scans, its order of sums, and the
// luminances that it reads back from the check picture it paints.
#pragma once
#include "evalglare/settings.h"
#include "glare/measure.h"

namespace evalglare {

// Geometry and sources of evalglare, for a glare::Plan.
glare::Methods methods(const Settings& settings);

}  // namespace evalglare
