// SPDX-License-Identifier: BSD-3-Clause
// evalglare's own lines, byte for byte where the numbers agree (-like evalglare): default, -d, -D, -V, -1, -2, -z a 3.
#pragma once
#include <string>
#include "glare/measure.h"

namespace glare {

struct EvalglareOutput {
    bool detailed = false;    // -d
    bool dgp_and_ev = false;  // -D
    bool ev_only = false;     // -V
};

std::string evalglare_lines(const Measurement& m, const Settings& settings, const EvalglareOutput& out,
                            const Meter& meter);
// What evalglare writes to stdout before it gives up on a perspective picture with black corners.
std::string evalglare_black_corners(double percent, bool stopping);

}  // namespace glare
