// SPDX-License-Identifier: BSD-3-Clause
// evalglare's own lines, byte for byte where the numbers agree (-like evalglare): default, -d, -D, -V, -1, -2, -z a 3.
#pragma once
#include <string>
#include "evalglare/settings.h"
#include "glare/measure.h"

namespace evalglare {

std::string lines(const glare::Measurement& m, const Settings& settings, const glare::Reading& reading);
// The text that evalglare writes to stdout before it gives up on a picture; empty: nothing.
std::string stdout_text(const base::Error& refusal);

}  // namespace evalglare
