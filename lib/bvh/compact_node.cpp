// SPDX-License-Identifier: BSD-3-Clause
// See compact_node.h.
#include "bvh/compact_node.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace kernels {
#include "kernels/geom/shapes.h"
#include "kernels/bvh/woop.h"
#include "kernels/bvh/bvh_compact.h"
}  // namespace kernels

namespace bvh {
namespace {
using namespace kernels;

Bounds around(const Bounds* const box[compact_slots]) {
    Bounds all = empty_bounds();
    bool any = false;
    for (unsigned k = 0; k < compact_slots; k++) {
        if (!box[k]) continue;
        any = true;
        grow(all, box[k]->lo);
        grow(all, box[k]->hi);
    }
    return any ? all : Bounds{};
}

// The least power of two of which 255 reach that far, as the exponent of a float.
uint32_t step_exponent(double extent) {
    if (!(extent > 0)) return 1;
    int e;
    const double mantissa = std::frexp(extent / 255, &e);
    if (mantissa == 0.5) e--;
    return uint32_t(std::clamp(e + 127, 1, 254));
}

}  // namespace

void choose_slots(const Bounds* box, unsigned count, unsigned slot[compact_slots]) {
    Bounds all = empty_bounds();
    for (unsigned i = 0; i < count; i++) {
        grow(all, box[i].lo);
        grow(all, box[i].hi);
    }
    double along[compact_slots][compact_slots];
    for (unsigned i = 0; i < count; i++) {
        double to[3];  // twice the way from the node's centre to the child's
        for (int a = 0; a < 3; a++) to[a] = double(box[i].lo[a]) + box[i].hi[a] - all.lo[a] - double(all.hi[a]);
        for (unsigned s = 0; s < compact_slots; s++)
            along[i][s] = (s & 1 ? to[0] : -to[0]) + (s & 2 ? to[1] : -to[1]) + (s & 4 ? to[2] : -to[2]);
    }
    unsigned waiting = (1u << count) - 1, open = 255;
    while (waiting != 0) {
        unsigned child = compact_slots, best = 0;
        for (unsigned i = 0; i < count; i++)
            for (unsigned s = 0; s < compact_slots; s++)
                if ((waiting >> i & 1) && (open >> s & 1) &&
                    (child == compact_slots || along[i][s] > along[child][best]))
                    child = i, best = s;
        slot[child] = best;
        waiting &= ~(1u << child);
        open &= ~(1u << best);
    }
}

void write_compact_node(float* at, const Bounds* const box[compact_slots], const uint32_t ref[compact_slots]) {
    const Bounds all = around(box);
    uint32_t word = 0, first = 0, block = 0;
    unsigned char bytes[2 * 3 * compact_slots] = {}, leaf[compact_slots] = {};
    for (unsigned k = compact_slots; k-- > 0;) {
        if (!box[k]) continue;
        if (ref[k] & REF_LEAF) block = ref[k] & REF_INDEX;
        else word |= 1u << (24 + k), first = ref[k];
    }
    for (unsigned a = 0; a < 3; a++) {
        const uint32_t exponent = step_exponent(double(all.hi[a]) - all.lo[a]);
        const double step = std::ldexp(1.0, int(exponent) - 127);
        word |= exponent << 8 * a;
        for (unsigned k = 0; k < compact_slots; k++) {
            if (!box[k]) continue;
            const double lo = std::floor((double(box[k]->lo[a]) - all.lo[a]) / step);
            const double hi = std::ceil((double(box[k]->hi[a]) - all.lo[a]) / step);
            bytes[16 * a + k] = static_cast<unsigned char>(lo);
            bytes[16 * a + 8 + k] = static_cast<unsigned char>(std::min(hi, 255.0));
        }
        at[a] = all.lo[a];
    }
    for (unsigned k = 0; k < compact_slots; k++)
        if (box[k] && (ref[k] & REF_LEAF))
            leaf[k] = static_cast<unsigned char>(COMPACT_LEAF + ((ref[k] & REF_INDEX) - block));
    at[3] = as_float_(word);
    at[4] = as_float_(first);
    at[5] = as_float_(block);
    std::memcpy(at + 6, leaf, sizeof leaf);
    std::memcpy(at + 8, bytes, sizeof bytes);
}

}  // namespace bvh
