// SPDX-License-Identifier: BSD-3-Clause
// The schedule of a pass: the order in which the stages of kernels/integrator/path.h run over queues of paths (Laine,
// Karras and Aila 2013, "Megakernels Considered Harmful").  A backend runs one stage over all paths of its queue:
//   has_paths()         are there paths in the queue?
//   extend()            their rays' first hits
//   shade()             shades these; fills the queues of the next bounce and of shadow rays
//   shadow()            light of the shadow rays that nothing stops
//   next_bounce()       the queue of the next bounce becomes the present one
//   in_reuse_parts(f)   calls f with backends of parts of the pass, in each of which groups of path reuse are whole
// and, over all paths of such a part, the stages of reuse_suffixes().
// CPU tiles (cpu_backend.h), one path at a time or in lanes, and OpenCL (opencl_paths.h) are backends.
#pragma once

namespace device {

// Follows the paths of the queue to their ends.
template <class Backend>
void follow_paths(Backend& b) {
    while (b.has_paths()) {
        b.extend();
        b.shade();
        b.shadow();
        b.next_bounce();
    }
}

// Suffix vertices light the prefix vertices of their groups (kernels/integrator/connect.h).
template <class Backend>
void reuse_suffixes(Backend& b) {
    b.suffix_roulette();
    b.see_connections();
    b.attenuate_connections();
    b.connect();
    b.normalise_mis();
    b.gather();
}

// The same for many hours, whose light is not known yet: groups meet in turn (kernels/integrator/path_reuse.h).  keep()
// takes what a round has found.
template <class Backend, class Keep>
void meet_suffixes(Backend& b, uint32_t rounds, Keep&& keep) {
    b.suffix_roulette();
    for (uint32_t round = 0; round < rounds; round++) {
        b.begin_round(REUSE_FIRST(round));
        b.see_connections();
        b.attenuate_connections();
        b.connect();
        keep();
    }
}

// The paths of a pass, from the eye.
template <class Backend>
void run_paths(Backend& b, bool reuse) {
    b.generate();
    follow_paths(b);
    if (reuse) b.in_reuse_parts([](auto& part) { reuse_suffixes(part); });
}

}  // namespace device
