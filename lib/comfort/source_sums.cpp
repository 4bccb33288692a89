// SPDX-License-Identifier: BSD-3-Clause
// Four sums side by side: what a pixel adds to them goes with its grey (source_sums.h).
#include "comfort/source_sums.h"

#include <cstring>

#include "base/wide.h"

namespace comfort {
namespace {

using Four = double __attribute__((vector_size(32)));
static_assert(sizeof(Four) == sizeof(SourceSum));

inline __attribute__((always_inline)) void add(const Four& more, SourceSum& to) {
    Four sum;
    std::memcpy(&sum, &to, sizeof sum);
    sum += more;
    std::memcpy(static_cast<void*>(&to), &sum, sizeof sum);
}

WIDE_LOOP void add_pixels(const Swayed& lum, const Geometry& g, uint32_t start, uint32_t length, CommonSums& to,
                          SourceSum* off) {
    Four mean = {}, own = {};
    double omegas = 0;
    const double y = g.y_of(start);
    double x = g.x_of(start);
    for (uint32_t p = start; p < start + length; ++p, ++x) {
        const double omega = g.omega[p];
        const Four each = {omega, omega * x, omega * y, g.omega_cos[p]};
        const double plus = lum.mean[p] + lum.off[p], minus = lum.mean[p] - lum.off[p];
        const double sign = 1 - 2 * int(lum.pattern[p] / Signs::turned);  // no branch: half of them would be a surprise
        omegas += omega;
        mean += double(lum.mean[p]) * each;
        own += (plus + minus) / 2 * each;
        add(sign * (plus - minus) / 2 * each, off[lum.pattern[p] % Signs::turned]);
    }
    to.omega += omegas;
    add(mean, to.mean), add(own, to.own);
}

}  // namespace

void add_stretch(const Swayed& lum, const Geometry& geometry, uint32_t start, uint32_t length, CommonSums& to,
                 SourceSum* off) {
    add_pixels(lum, geometry, start, length, to, off);
}

}  // namespace comfort
