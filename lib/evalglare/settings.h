// SPDX-License-Identifier: BSD-3-Clause
// Options that only evalglare's own lines and its check picture have.  The letters are evalglare's.
#pragma once
#include <optional>

namespace evalglare {

// Fractions of the luminance that red, green and blue give.
struct Paint {
    double red, green, blue;
};

struct Settings {
    bool detailed = false;              // -d
    bool dgp_and_ev = false;            // -D
    bool ev_only = false;               // -V
    int fast = 0;                       // -1, -2, -3
    double fast_direct = 0;             // -2 Edir
    bool task_painted = false;          // -T
    std::optional<Paint> source_paint;  // -u: of all sources; else five colours in turn
};

}  // namespace evalglare
